// SPDX-License-Identifier: Apache-2.0
// A hierarchy of bounding volumes and the way of a ray through it (Rubin and Whitted 1980, "A
// 3-Dimensional Representation for Fast Rendering of Complex Scenes"; Kay and Kajiya 1986, "Ray
// Tracing Complex Scenes", for the nearest volume first). Who made the tree and which volumes are
// in it are two template arguments, so that structures differ in nothing but what they are named
// after.
//
// A Volume is a type with
//   using Ray = ...;  made of (const ObjectRay&, const Bounds& all) once a traversal
//   Interval1D clip(const Ray& ray, double t_min, double t_max) const;
//                     where the ray is inside, never less than that whatever is rounded
//   static Volume around(const Bounds& box, std::span<const Vec3> points);
//                     around all that is in the box and in the convex hull of the points
//   static constexpr bool k_needs_points = ...;  false: the box is enough, and no points are given
// and a function half_area(const Volume&) beside it.
#pragma once

#include "geometry/accelerators/bvh/tree.h"
#include "geometry/accelerators/slab.h"
#include "geometry/accelerators/traversal_cost.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace lume::geometry::bvh {

/// The nodes of a tree with volumes in the place of boxes.
template <class Volume>
[[nodiscard]] std::vector<Node<Volume>> wrap_nodes(const BinaryTree& tree, const Items& items) {
  const NodePoints points(tree, items, Volume::k_needs_points);
  std::vector<Node<Volume>> nodes;
  nodes.reserve(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node<Bounds>& node = tree.nodes[i];
    nodes.push_back({Volume::around(node.volume, points.below(i)), node.first, node.count});
  }
  return nodes;
}

/// A Structure for TwoLevel (two_level.h).
template <class Volume, BuildTree* build>
class Hierarchy {
 public:
  explicit Hierarchy(const Items& items) : all_(items.all_bounds()) {
    BinaryTree tree = build(items);
    nodes_ = wrap_nodes<Volume>(tree, items);
    references_ = std::move(tree.references);
  }

  template <class Visit, class Cost>
  bool traverse(const ObjectRay& ray, const Visit& visit, Cost& cost) const {
    if (nodes_.empty()) return false;
    const typename Volume::Ray volume_ray(ray, all_);
    const auto arrive = [&](std::uint32_t node) {
      const Interval1D inside = nodes_[node].volume.clip(volume_ray, ray.t_min, ray.t_max);
      return Arrival{inside.is_empty() ? k_never : inside.enter, node};
    };
    Arrival waiting[k_max_depth + 1];  // of each node on the way down one child, and the last one
    int count = 0;
    const Arrival root = arrive(0);
    if (root.t < k_never) waiting[count++] = root;
    while (count > 0) {
      const Arrival next = waiting[--count];
      // Something nearer was met since. What begins just there may hold a lower identity.
      if (next.t > ray.t_max) continue;
      const Node<Volume>& node = nodes_[next.node];
      if (node.is_leaf()) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          if (visit(references_[i])) return true;
        }
        continue;
      }
      cost.add_node();
      Arrival near = arrive(node.first);
      Arrival far = arrive(node.first + 1);
      if (far.t < near.t) std::swap(near, far);
      if (far.t < k_never) waiting[count++] = far;
      if (near.t < k_never) waiting[count++] = near;
    }
    return false;
  }

  [[nodiscard]] StructureStats stats() const {
    StructureStats stats;
    for (const Node<Volume>& node : nodes_) ++(node.is_leaf() ? stats.leaves : stats.nodes);
    stats.depth = depth(nodes_);
    stats.references = references_.size();
    stats.sah_cost = sah_cost(nodes_);
    stats.memory_bytes =
        nodes_.size() * sizeof(Node<Volume>) + references_.size() * sizeof(std::uint32_t);
    return stats;
  }

 private:
  static constexpr double k_never = std::numeric_limits<double>::infinity();

  /// Where the ray enters a node.
  struct Arrival {
    double t;
    std::uint32_t node;
  };

  Bounds all_;
  std::vector<Node<Volume>> nodes_;
  std::vector<std::uint32_t> references_;
};

}  // namespace lume::geometry::bvh
