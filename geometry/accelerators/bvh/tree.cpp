// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/tree.h"

namespace lume::geometry::bvh {

void fit_boxes(BinaryTree& tree, const Items& items) {
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    Node<Bounds>& node = tree.nodes[i];
    node.volume = {};
    if (node.is_leaf()) {
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        node.volume.add(items.bounds(tree.references[k]));
      }
    } else {
      node.volume.add(tree.nodes[node.first].volume);
      node.volume.add(tree.nodes[node.first + 1].volume);
    }
  }
}

NodePoints::NodePoints(const BinaryTree& tree, const Items& items, bool wanted) {
  if (!wanted) return;
  std::vector<std::size_t> first_of_reference;
  first_of_reference.reserve(tree.references.size() + 1);
  for (const std::uint32_t item : tree.references) {
    first_of_reference.push_back(points_.size());
    items.add_points(item, points_);
  }
  first_of_reference.push_back(points_.size());
  ranges_.resize(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node<Bounds>& node = tree.nodes[i];
    if (node.is_leaf()) {
      const std::size_t first = first_of_reference[node.first];
      ranges_[i] = {first, first_of_reference[node.first + node.count] - first};
    } else {
      const Range& left = ranges_[node.first];
      ranges_[i] = {left.first, left.count + ranges_[node.first + 1].count};
    }
  }
}

}  // namespace lume::geometry::bvh
