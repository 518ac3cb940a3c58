// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/triangle_tree.h"

#include "geometry/accelerators/wide/builder.h"

#include <algorithm>

namespace lume::geometry::wide {

TriangleTree::TriangleTree(const TriangleItems& items, bool has_holes)
    : tree_(build_tree(items)), bounds_(items.all_bounds()), has_holes_(has_holes) {
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const Hit id = items.identity(i);
    if (!runs_.empty()) {
      const auto& [first, begin] = runs_.back();
      if (id == Hit{begin.instance, begin.geometry, begin.primitive + (i - first)}) continue;
    }
    runs_.push_back({i, id});
  }
}

Hit TriangleTree::identity(std::uint32_t item) const {
  const auto after =
      std::upper_bound(runs_.begin(), runs_.end(), item,
                       [](std::uint32_t i, const Run& run) { return i < run.first; });
  const auto& [first, begin] = *(after - 1);
  return {begin.instance, begin.geometry, begin.primitive + (item - first)};
}

std::uint32_t TriangleTree::first_above(const Hit& hit) const {
  const auto run = std::lower_bound(runs_.begin(), runs_.end(), hit,
                                    [](const Run& r, const Hit& h) { return r.id < h; });
  return run == runs_.end() ? k_no_item : run->first;
}

}  // namespace lume::geometry::wide
