// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "renderer/bench/ray_sets.h"

#include <cstddef>
#include <optional>

namespace lume::renderer {

/// What rays look at on their way, on average.
struct MeanCost {
  std::size_t rays = 0;
  double nodes = 0.0;            ///< a ray
  double primitive_tests = 0.0;  ///< a ray
};

/// Nothing for a structure that does not count, and for an empty set. At most so many rays, in runs
/// spread over the set.
[[nodiscard]] std::optional<MeanCost> mean_cost(const geometry::Accelerator& accelerator,
                                                const RaySet& set, std::size_t most_rays);

}  // namespace lume::renderer
