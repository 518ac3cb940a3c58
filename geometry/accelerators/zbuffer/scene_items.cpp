// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/scene_items.h"

#include <algorithm>
#include <limits>

namespace lume::geometry::zbuffer {

SceneItems::SceneItems(const World& world) : world_(world) {
  std::vector<Bounds> of_triangles;
  of_triangles.reserve(world.objects.size());
  for (const Object& object : world.objects) {
    of_triangles.push_back(triangles_.emplace_back(object).all_bounds());
  }
  placements_.emplace(world, of_triangles);
  first_.reserve(placements_->size() + 1);
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < placements_->size(); ++i) {
    first_.push_back(static_cast<std::uint32_t>(count));
    const Placement& placement = placements_->placement(i);
    count += placement.shape ? 1 : triangles_[world.instances[placement.instance].object].size();
  }
  first_.push_back(static_cast<std::uint32_t>(count));
  const std::vector<Placement>& endless = placements_->endless();
  can_draw_ = count <= std::numeric_limits<std::uint32_t>::max() &&
              std::all_of(endless.begin(), endless.end(),
                          [](const Placement& placement) { return placement.shape.has_value(); });
}

ItemRange SceneItems::range_of(std::uint32_t item) const {
  const auto after = std::upper_bound(first_.begin(), first_.end(), item);
  return range(static_cast<std::uint32_t>(after - first_.begin() - 1));
}

std::size_t SceneItems::memory_bytes() const {
  std::size_t bytes = first_.size() * sizeof(std::uint32_t);
  for (const TriangleItems& triangles : triangles_) {
    bytes += triangles.size() * (sizeof(Bounds) + sizeof(Hit) + sizeof(void*));
  }
  return bytes;
}

}  // namespace lume::geometry::zbuffer
