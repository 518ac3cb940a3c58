// SPDX-License-Identifier: Apache-2.0
// The plain binary tree that every builder makes and every volume is put around: which items are
// together, and the box around them. How a ray goes through it is hierarchy.h's business.
#pragma once

#include "geometry/accelerators/items.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lume::geometry::bvh {

/// Half the surface of a box; 0 of an empty one. In double, where no finite box overflows.
[[nodiscard]] inline double half_area(const Bounds& box) {
  if (box.is_empty()) return 0.0;
  const DVec3 size = DVec3(box.upper) - DVec3(box.lower);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// A node whose items are held together by a volume: a box, a sphere, ...
template <class Volume>
struct Node {
  Volume volume;
  std::uint32_t first = 0;  ///< of its two children side by side; of a leaf its first reference
  std::uint32_t count = 0;  ///< references of a leaf; 0: an inner node

  [[nodiscard]] bool is_leaf() const { return count != 0; }
};

/// Node 0 is the root, and children come after their parents. Leaves hold ranges of `references`,
/// depth first: what is below any node is one range. There are no nodes if there are no items.
struct BinaryTree {
  std::vector<Node<Bounds>> nodes;
  std::vector<std::uint32_t> references;  ///< numbers of items
};

/// A builder: sorts items into a tree.
using BuildTree = BinaryTree(const Items& items);

/// No builder lets more inner nodes lie between the root and a leaf, the root counted: a traversal
/// can keep what it has still to visit in an array of this size.
inline constexpr int k_max_depth = 96;
/// Builders whose splits may be uneven halve the number of items from this depth on, and 2^32 items
/// can be halved 32 times.
inline constexpr int k_free_depth = 64;
/// Boxes in the same place cannot be told apart; so many stay together without a question.
inline constexpr std::uint32_t k_most_in_leaf = 8;

/// Puts boxes around what leaves refer to, and around children.
void fit_boxes(BinaryTree& tree, const Items& items);

/// The points whose convex hull holds the items below a node.
class NodePoints {
 public:
  /// Of no node any, if they are not wanted.
  NodePoints(const BinaryTree& tree, const Items& items, bool wanted);

  [[nodiscard]] std::span<const Vec3> below(std::size_t node) const {
    if (ranges_.empty()) return {};
    return std::span(points_).subspan(ranges_[node].first, ranges_[node].count);
  }

 private:
  struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  std::vector<Vec3> points_;
  std::vector<Range> ranges_;  ///< by node
};

/// The most inner nodes on the way to a leaf.
template <class Volume>
[[nodiscard]] std::size_t depth(const std::vector<Node<Volume>>& nodes) {
  std::vector<std::size_t> depths(nodes.size(), 0);
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].is_leaf()) continue;
    deepest = std::max(deepest, depths[i] + 1);
    depths[nodes[i].first] = depths[nodes[i].first + 1] = depths[i] + 1;
  }
  return deepest;
}

/// What a ray through the root is expected to cost: 1 for each inner node that it enters and 1 for
/// each item in a leaf that it enters. Of two convex volumes, one inside the other, the inner one
/// is met by the part of rays that its surface has of the outer one's (MacDonald and Booth 1990,
/// "Heuristics for Ray Tracing Using Space Subdivision", equation 2). half_area(volume) is found
/// where the volume is declared.
template <class Volume>
[[nodiscard]] double sah_cost(const std::vector<Node<Volume>>& nodes) {
  if (nodes.empty()) return 0.0;
  const double root_area = half_area(nodes[0].volume);
  double cost = 0.0;
  for (const Node<Volume>& node : nodes) {
    // All in one point: every ray that meets the root meets all of it.
    const double chance = root_area > 0.0 ? half_area(node.volume) / root_area : 1.0;
    cost += chance * (node.is_leaf() ? node.count : 1.0);
  }
  return cost;
}

}  // namespace lume::geometry::bvh
