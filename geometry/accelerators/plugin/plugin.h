// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/accelerator.h"

namespace lume::geometry {

/// A structure from a shared library; `holes` may be null. Throws std::runtime_error where the
/// plugin can be seen to be wrong: when it is loaded, when it builds, and from queries whose answer
/// cannot be true.
[[nodiscard]] std::unique_ptr<Accelerator> make_plugin(const std::string& file, const World& world,
                                                       const HoleTest* holes);

}  // namespace lume::geometry
