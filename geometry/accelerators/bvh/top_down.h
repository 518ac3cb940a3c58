// SPDX-License-Identifier: Apache-2.0
// What all builders from the root down have in common: a list of items, and a way to put a part of
// it in such an order that one child's items come before the other's.
#pragma once

#include "geometry/accelerators/bvh/tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lume::geometry::bvh {

/// An item as builders sort it: what they look at all the time beside its number.
struct Entry {
  Bounds box;
  std::uint32_t item = 0;

  /// Twice the centroid of the box along an axis: in double, where the sum is nearly never rounded.
  [[nodiscard]] double twice_centroid(int axis) const {
    return static_cast<double>(box.lower[axis]) + static_cast<double>(box.upper[axis]);
  }
};

/// All items, in their order.
[[nodiscard]] std::vector<Entry> list_entries(const Items& items);

/// Around twice the centroids.
[[nodiscard]] DBounds centroid_bounds(std::span<const Entry> entries);

/// The order of centroids along an axis; of those in the same place by number, so that there is
/// only one such order.
struct CentroidBefore {
  int axis = 0;

  bool operator()(const Entry& a, const Entry& b) const {
    const double centroid_a = a.twice_centroid(axis);
    const double centroid_b = b.twice_centroid(axis);
    return centroid_a != centroid_b ? centroid_a < centroid_b : a.item < b.item;
  }
};

/// Makes a tree's nodes over a list of items: split(part, depth) puts a part of the list in order
/// and says how many entries the first child gets; 0 makes a leaf.
template <class ListEntry, class Split>
class TopDown {
 public:
  TopDown(std::vector<ListEntry>& list, const Split& split) : list_(list), split_(split) {
    if (list.empty()) return;
    nodes_.reserve(list.size());  // as leaves have some two items
    nodes_.emplace_back();
    grow(0, 0, list.size(), 0);
  }

  [[nodiscard]] std::vector<Node<Bounds>>& nodes() { return nodes_; }

 private:
  void grow(std::size_t node, std::size_t begin, std::size_t count, int depth) {
    const std::size_t split =
        count > 1 ? split_(std::span(list_).subspan(begin, count), depth) : std::size_t{0};
    if (split == 0) {
      nodes_[node].first = static_cast<std::uint32_t>(begin);
      nodes_[node].count = static_cast<std::uint32_t>(count);
      return;
    }
    const std::size_t first = nodes_.size();
    nodes_[node].first = static_cast<std::uint32_t>(first);
    nodes_.resize(first + 2);
    grow(first, begin, split, depth + 1);
    grow(first + 1, begin + split, count - split, depth + 1);
  }

  std::vector<ListEntry>& list_;
  const Split& split_;
  std::vector<Node<Bounds>> nodes_;
};

/// A tree over a list whose entries name an item each, in the order that `split` (see TopDown)
/// leaves them in.
template <class ListEntry, class Split>
[[nodiscard]] BinaryTree build_top_down(const Items& items, std::vector<ListEntry>& list,
                                        const Split& split) {
  BinaryTree tree;
  tree.nodes = std::move(TopDown(list, split).nodes());
  tree.references.reserve(list.size());
  for (const ListEntry& entry : list) tree.references.push_back(entry.item);
  fit_boxes(tree, items);
  return tree;
}

}  // namespace lume::geometry::bvh
