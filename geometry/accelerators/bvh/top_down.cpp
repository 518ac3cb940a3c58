// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/top_down.h"

namespace lume::geometry::bvh {

std::vector<Entry> list_entries(const Items& items) {
  std::vector<Entry> entries;
  entries.reserve(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) entries.push_back({items.bounds(i), i});
  return entries;
}

DBounds centroid_bounds(std::span<const Entry> entries) {
  DBounds bounds;
  for (const Entry& entry : entries) {
    bounds.add({entry.twice_centroid(0), entry.twice_centroid(1), entry.twice_centroid(2)});
  }
  return bounds;
}

}  // namespace lume::geometry::bvh
