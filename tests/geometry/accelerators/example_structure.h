// SPDX-License-Identifier: Apache-2.0
// The simplest structure there is: a list of boxes. A triangle is tested only if its box is met.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/accelerators/slab.h"
#include "geometry/accelerators/traversal_cost.h"

namespace lume::geometry {

class BoxList {
 public:
  explicit BoxList(const Items& items) : all_(items.all_bounds()) {
    boxes_.reserve(items.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) boxes_.push_back(items.bounds(i));
  }

  template <class Visit, class Cost>
  bool traverse(const ObjectRay& ray, const Visit& visit, Cost& cost) const {
    const SlabRay slabs(ray, all_);
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      cost.add_node();
      // visit() lowers ray.t_max when it finds something nearer.
      if (slabs.clip(boxes_[i], ray.t_min, ray.t_max).is_empty()) continue;
      if (visit(i)) return true;
    }
    return false;
  }

  [[nodiscard]] StructureStats stats() const {
    StructureStats stats;
    stats.leaves = stats.references = boxes_.size();
    stats.memory_bytes = boxes_.size() * sizeof(Bounds);
    return stats;
  }

 private:
  Bounds all_;
  std::vector<Bounds> boxes_;
};

}  // namespace lume::geometry
