// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/median.h"

#include <algorithm>

namespace lume::geometry::bvh {

std::size_t halve(std::span<Entry> entries) {
  const int axis = dominant_axis(centroid_bounds(entries).size());
  const std::size_t half = entries.size() / 2;
  std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(half),
                   entries.end(), CentroidBefore{axis});
  return half;
}

BinaryTree build_median(const Items& items) {
  constexpr std::size_t k_leaf = 4;
  std::vector<Entry> list = list_entries(items);
  return build_top_down(items, list, [](std::span<Entry> entries, int /*depth*/) {
    return entries.size() > k_leaf ? halve(entries) : 0;
  });
}

}  // namespace lume::geometry::bvh
