// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/cost.h"

#include "renderer/bench/measure.h"

namespace lume::renderer {

std::optional<MeanCost> mean_cost(const geometry::Accelerator& accelerator, const RaySet& set,
                                  std::size_t most_rays) {
  if (!accelerator.counts_cost() || set.rays.empty()) return std::nullopt;
  geometry::TraversalCost cost;
  const std::vector<geometry::Ray> rays = spread_rays(set.rays, most_rays);
  for (const geometry::Ray& ray : rays) {
    if (set.any_hit) {
      (void)accelerator.any_hit_counted(ray, cost);
    } else {
      (void)accelerator.closest_hit_counted(ray, cost);
    }
  }
  const auto count = static_cast<double>(rays.size());
  return MeanCost{rays.size(), static_cast<double>(cost.nodes) / count,
                  static_cast<double>(cost.primitive_tests) / count};
}

}  // namespace lume::renderer
