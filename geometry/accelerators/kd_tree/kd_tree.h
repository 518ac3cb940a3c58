// SPDX-License-Identifier: Apache-2.0
// The kd-tree: space is cut in two by a plane across an axis, and each half again, where the
// surface area heuristic expects rays to gain most (Wald and Havran 2006, "On building fast
// kd-Trees for Ray Tracing, and on doing that in O(N log N)"). Halves do not overlap, so a ray
// meets them strictly one after the other; the price is that an item which a plane cuts is in both.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/accelerators/mailbox.h"
#include "geometry/accelerators/slab.h"
#include "geometry/accelerators/traversal_cost.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lume::geometry::kd_tree {

/// No more inner nodes lie between the root and a leaf, the root counted.
inline constexpr int k_max_depth = 64;

struct Node {
  float place = 0.0f;       ///< of the plane
  std::uint32_t first = 0;  ///< of its two children side by side; of a leaf its first reference
  std::uint32_t kind = 0;   ///< the axis across which the plane lies; of a leaf 3 + references

  [[nodiscard]] bool is_leaf() const { return kind >= 3; }
  [[nodiscard]] int axis() const { return static_cast<int>(kind); }
  [[nodiscard]] std::uint32_t count() const { return kind - 3; }
};

/// A Structure for TwoLevel (two_level.h).
class KdTree {
 public:
  explicit KdTree(const Items& items);

  /// Havran 2000, "Heuristic Ray Shooting Algorithms": the interval of t in which the
  /// ray is in a node is cut in two by the plane. Here the parts overlap by what may be rounded.
  template <class Visit, class Cost>
  bool traverse(const ObjectRay& ray, const Visit& visit, Cost& cost) const {
    if (references_.empty()) return false;
    const SlabRay slabs(ray, all_);
    Waiting waiting[k_max_depth + 1];
    int count = 0;
    const Interval1D whole = slabs.clip(all_, ray.t_min, ray.t_max);
    if (!whole.is_empty()) waiting[count++] = {0, whole.enter, whole.leave};
    Mailbox mailbox;
    while (count > 0) {
      auto [index, enter, leave] = waiting[--count];
      // Something nearer was met since. What begins just there may hold a lower identity.
      if (enter > ray.t_max) continue;
      while (!nodes_[index].is_leaf()) {
        cost.add_node();
        const Node& node = nodes_[index];
        const int axis = node.axis();
        const double earliest = slabs.earliest(axis, node.place);
        const double latest = slabs.latest(axis, node.place);
        const std::uint32_t second = slabs.backwards(axis) ? 0 : 1;
        index = node.first + 1 - second;
        if (latest < enter) {
          index = node.first + second;
        } else if (earliest <= leave) {
          waiting[count++] = {node.first + second, std::max(enter, earliest), leave};
          leave = std::min(leave, latest);
        }
      }
      const Node& leaf = nodes_[index];
      for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
        if (mailbox.is_new(references_[i]) && visit(references_[i])) return true;
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

  Bounds all_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> references_;
  double sah_cost_ = 0.0;
  std::size_t depth_ = 0;
};

}  // namespace lume::geometry::kd_tree
