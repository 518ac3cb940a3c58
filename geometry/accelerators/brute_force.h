// SPDX-License-Identifier: Apache-2.0
// Every ray against every primitive: the oracle that the other structures are tested against.
#pragma once

#include "geometry/accelerators/accelerator.h"

namespace lume::geometry {

/// `holes` may be null. Both arguments must outlive the result.
[[nodiscard]] std::unique_ptr<Accelerator> make_brute_force(const World& world,
                                                            const HoleTest* holes);

}  // namespace lume::geometry
