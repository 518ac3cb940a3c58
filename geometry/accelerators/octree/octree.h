// SPDX-License-Identifier: Apache-2.0
// The octree (Glassner 1984, "Space Subdivision for Fast Ray Tracing"): a box that holds too much
// is cut in eight by three planes through its middle, again and again, so that cells are small
// where there is much and large where there is little.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/accelerators/mailbox.h"
#include "geometry/accelerators/slab.h"
#include "geometry/accelerators/traversal_cost.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lume::geometry::octree {

/// No more inner nodes lie between the root and a leaf, the root counted.
inline constexpr int k_max_depth = 24;

/// Bit i of a child's number (0 to 7) says whether it is above the middle along axis i.
[[nodiscard]] inline bool is_above(std::uint32_t child, int axis) {
  return (child >> static_cast<unsigned>(axis) & 1U) != 0;
}

struct Node {
  Vec3 middle{0.0f};        ///< where the three planes meet
  std::uint32_t first = 0;  ///< of its eight children side by side; of a leaf its first reference
  std::uint32_t count = 0;  ///< references of a leaf
  bool is_leaf = true;
};

/// A Structure for TwoLevel (two_level.h).
class Octree {
 public:
  explicit Octree(const Items& items);

  /// From the root down, as Revelles, Urena and Lastra 2000, "An Efficient Parametric Algorithm for
  /// Octree Traversal": where the ray is in a child follows from where it is in its parent and from
  /// three more values of t. A ray can only cross each plane once, towards its own side: if
  /// children are counted from the corner that it comes from, it meets them in the order of their
  /// numbers.
  template <class Visit, class Cost>
  bool traverse(const ObjectRay& ray, const Visit& visit, Cost& cost) const {
    if (references_.empty()) return false;
    const SlabRay slabs(ray, all_);
    std::uint32_t corner = 0;  // that the ray comes from
    for (int axis = 0; axis < 3; ++axis) {
      if (slabs.backwards(axis)) corner |= 1U << static_cast<unsigned>(axis);
    }
    Waiting waiting[7 * k_max_depth + 1];  // all but one child of each node on the way down
    int count = 0;
    const Interval1D whole = slabs.clip(all_, ray.t_min, ray.t_max);
    if (!whole.is_empty()) waiting[count++] = {0, whole.enter, whole.leave};
    Mailbox mailbox;
    while (count > 0) {
      const auto [index, enter, leave] = waiting[--count];
      // Something nearer was met since. What begins just there may hold a lower identity.
      if (enter > ray.t_max) continue;
      const Node& node = nodes_[index];
      if (node.is_leaf) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          if (mailbox.is_new(references_[i]) && visit(references_[i])) return true;
        }
        continue;
      }
      cost.add_node();
      const Crossings crossings(slabs, node.middle);
      for (std::uint32_t child = 8; child-- > 0;) {  // the first one on top
        const Interval1D part = crossings.clip({enter, leave}, child);
        if (!part.is_empty()) {
          waiting[count++] = {node.first + (child ^ corner), part.enter, part.leave};
        }
      }
    }
    return false;
  }

  [[nodiscard]] StructureStats stats() const;

 private:
  friend class Builder;

  /// A node, and where the ray is inside.
  struct Waiting {
    std::uint32_t node;
    double enter;
    double leave;
  };

  /// When a ray crosses the three planes of a node.
  struct Crossings {
    Crossings(const SlabRay& slabs, const Vec3& middle) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<double>(middle[axis]);
        earliest[axis] = slabs.earliest(axis, place);
        latest[axis] = slabs.latest(axis, place);
      }
    }

    /// The part in a child, whose number counts from the corner that the ray comes from: before
    /// the crossing along an axis, or after it.
    [[nodiscard]] Interval1D clip(Interval1D inside, std::uint32_t child) const {
      for (int axis = 0; axis < 3; ++axis) {
        if (is_above(child, axis)) {
          inside.enter = std::max(inside.enter, earliest[axis]);
        } else {
          inside.leave = std::min(inside.leave, latest[axis]);
        }
      }
      return inside;
    }

    double earliest[3] = {};
    double latest[3] = {};
  };

  Bounds all_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> references_;
  double sah_cost_ = 0.0;
  std::size_t depth_ = 0;
};

}  // namespace lume::geometry::octree
