// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/reinsertion.h"

#include "geometry/accelerators/bvh/binned_sah.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lume::geometry::bvh {
namespace {

constexpr std::uint32_t k_none = std::numeric_limits<std::uint32_t>::max();

/// A node that can be hung elsewhere.
struct Link {
  Bounds box;
  double area = 0.0;
  std::uint32_t parent = k_none;
  std::uint32_t child[2] = {k_none, k_none};  ///< none: a leaf, the one of this index in the tree

  [[nodiscard]] bool is_leaf() const { return child[0] == k_none; }
};

Bounds joined(Bounds a, const Bounds& b) {
  a.add(b);
  return a;
}

class LinkedTree {
 public:
  explicit LinkedTree(const std::vector<Node<Bounds>>& nodes) : links_(nodes.size()) {
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      links_[i].box = nodes[i].volume;
      links_[i].area = half_area(nodes[i].volume);
      if (!nodes[i].is_leaf()) adopt(i, nodes[i].first, nodes[i].first + 1);
    }
  }

  [[nodiscard]] const Link& operator[](std::uint32_t i) const { return links_[i]; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(links_.size()); }
  [[nodiscard]] std::uint32_t root() const { return root_; }

  /// The measure of section 3.3: how much larger a node is than its children, together and the
  /// smaller one, and how large it is.
  [[nodiscard]] double badness(std::uint32_t node) const {
    const Link& link = links_[node];
    if (!can_dissolve(node) || link.area == 0.0) return 0.0;
    const double a = links_[link.child[0]].area;
    const double b = links_[link.child[1]].area;
    const double least = 1e-6 * link.area;  // so that children without area do not count for all
    return link.area / std::max(0.5 * (a + b), least) * link.area /
           std::max(std::min(a, b), least) * link.area;
  }

  /// Takes an inner node and its parent out, and hangs the node's children in again, the larger one
  /// first, each where it costs least (section 3.1).
  void dissolve(std::uint32_t node) {
    if (!can_dissolve(node)) return;
    const std::uint32_t parent = links_[node].parent;
    const std::uint32_t sibling = links_[parent].child[links_[parent].child[0] == node ? 1 : 0];
    std::uint32_t first = links_[node].child[0];
    std::uint32_t second = links_[node].child[1];
    if (links_[first].area < links_[second].area) std::swap(first, second);
    const std::uint32_t above = links_[parent].parent;
    take_place(parent, sibling);
    fit_upwards(above);
    hang(first, find_place(first), node);
    hang(second, find_place(second), parent);
  }

 private:
  /// Neither a leaf nor so high up that nothing would be left to hang from.
  [[nodiscard]] bool can_dissolve(std::uint32_t node) const {
    const std::uint32_t parent = links_[node].parent;
    return !links_[node].is_leaf() && parent != k_none && links_[parent].parent != k_none;
  }

  void adopt(std::uint32_t parent, std::uint32_t first, std::uint32_t second) {
    links_[parent].child[0] = first;
    links_[parent].child[1] = second;
    links_[first].parent = links_[second].parent = parent;
  }

  /// Hangs a node where another one hangs.
  void take_place(std::uint32_t old_node, std::uint32_t new_node) {
    const std::uint32_t parent = links_[old_node].parent;
    links_[new_node].parent = parent;
    if (parent == k_none) {
      root_ = new_node;
    } else {
      links_[parent].child[links_[parent].child[0] == old_node ? 0 : 1] = new_node;
    }
  }

  void fit_upwards(std::uint32_t node) {
    for (; node != k_none; node = links_[node].parent) {
      Link& link = links_[node];
      link.box = joined(links_[link.child[0]].box, links_[link.child[1]].box);
      link.area = half_area(link.box);
    }
  }

  /// Puts `joint` in the place of a node and hangs both the node and `other` from it.
  void hang(std::uint32_t other, std::uint32_t place, std::uint32_t joint) {
    take_place(place, joint);
    adopt(joint, place, other);
    fit_upwards(joint);
  }

  /// The node beside which `node` adds the least area to the tree, by branch and bound (section
  /// 3.2): what the nodes above grow by, and the area of the joint.
  std::uint32_t find_place(std::uint32_t node) {
    const Link& hung = links_[node];
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t place = root_;
    queue_.assign(1, {0.0, root_});
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end());
      const auto [grown, candidate] = queue_.back();
      queue_.pop_back();
      if (grown + hung.area >= least) break;
      const Link& link = links_[candidate];
      const double cost = grown + half_area(joined(link.box, hung.box));
      if (cost < least) {
        least = cost;
        place = candidate;
      }
      const double grown_below = cost - link.area;
      if (link.is_leaf() || grown_below + hung.area >= least) continue;
      for (const std::uint32_t child : link.child) {
        queue_.push_back({grown_below, child});
        std::push_heap(queue_.begin(), queue_.end());
      }
    }
    return place;
  }

  /// A node to look at, that of least growth above it first.
  struct Candidate {
    double grown = 0.0;
    std::uint32_t node = 0;

    bool operator<(const Candidate& other) const {
      return grown != other.grown ? grown > other.grown : node > other.node;
    }
  };

  std::vector<Link> links_;
  std::uint32_t root_ = 0;
  std::vector<Candidate> queue_;
};

/// Dissolves every inner node once, the worst ones first. Batches are small, because what is done
/// to the worst ones makes others better or worse.
void dissolve_all(LinkedTree& links) {
  constexpr std::uint32_t k_batches = 20;
  const std::uint32_t batch_size = links.size() / k_batches + 1;
  std::vector<bool> is_done(links.size(), false);
  std::vector<std::pair<double, std::uint32_t>> worst;  // the more negative the worse
  worst.reserve(links.size());
  do {
    worst.clear();
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      const double badness = is_done[i] ? 0.0 : links.badness(i);
      if (badness > 0.0) worst.emplace_back(-badness, i);
    }
    const auto count = std::min<std::size_t>(batch_size, worst.size());
    const auto end = worst.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(worst.begin(), end, worst.end());
    for (auto it = worst.begin(); it != end; ++it) {
      links.dissolve(it->second);
      is_done[it->second] = true;
    }
  } while (!worst.empty());
}

/// In depth-first order again, with the leaves' references.
BinaryTree as_tree(const LinkedTree& links, const BinaryTree& leaves) {
  BinaryTree tree;
  tree.nodes.reserve(links.size());
  tree.nodes.emplace_back();
  tree.references.reserve(leaves.references.size());
  std::vector<std::pair<std::uint32_t, std::size_t>> waiting{{links.root(), 0}};  // link, node
  while (!waiting.empty()) {
    const auto [link, node] = waiting.back();
    waiting.pop_back();
    tree.nodes[node].volume = links[link].box;
    if (links[link].is_leaf()) {
      const Node<Bounds>& leaf = leaves.nodes[link];
      const auto first = leaves.references.begin() + leaf.first;
      tree.nodes[node].first = static_cast<std::uint32_t>(tree.references.size());
      tree.nodes[node].count = leaf.count;
      tree.references.insert(tree.references.end(), first, first + leaf.count);
      continue;
    }
    const std::size_t children = tree.nodes.size();
    tree.nodes[node].first = static_cast<std::uint32_t>(children);
    tree.nodes.resize(children + 2);
    waiting.emplace_back(links[link].child[1], children + 1);
    waiting.emplace_back(links[link].child[0], children);
  }
  return tree;
}

}  // namespace

BinaryTree reinsert(const BinaryTree& tree) {
  constexpr int k_rounds = 2;
  if (tree.nodes.empty()) return tree;
  LinkedTree links(tree.nodes);
  for (int round = 0; round < k_rounds; ++round) dissolve_all(links);
  BinaryTree better = as_tree(links, tree);
  const bool is_better = sah_cost(better.nodes) < sah_cost(tree.nodes);
  return is_better && depth(better.nodes) <= k_max_depth ? better : tree;
}

BinaryTree build_reinserted(const Items& items) { return reinsert(build_binned_sah(items)); }

}  // namespace lume::geometry::bvh
