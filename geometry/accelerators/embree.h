// SPDX-License-Identifier: Apache-2.0
// Intel Embree 3 behind the Accelerator interface. All that is peculiar to Embree, its version
// included, stays in embree.cpp and embree_callbacks.
#pragma once

#include "geometry/accelerators/accelerator.h"

#include <string>

namespace lume::geometry {

/// `holes` may be null. Both arguments must outlive the result. The environment variable
/// LUME_EMBREE_CONFIG is handed to rtcNewDevice ("max_isa=sse4.2" lowers the instruction set).
/// Throws std::runtime_error with Embree's message when the structure cannot be built.
[[nodiscard]] std::unique_ptr<Accelerator> make_embree(const World& world, const HoleTest* holes);

/// Version of the Embree library that is loaded, "3.13.5".
[[nodiscard]] std::string embree_version();

}  // namespace lume::geometry
