// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/collapse.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lume::geometry::wide {
namespace {

/// What it costs to show a binary node's references as a forest of up to so many trees.
struct Costs {
  /// forest[i]: as i + 1 trees at most, of which 8 are a node's children.
  std::array<float, k_width> forest{};
  /// Of those trees, how many stand for the left child; 0: not cut here, fewer trees do as well.
  std::array<std::uint8_t, k_width> on_the_left{};
  std::uint32_t count = 0;  ///< references below
  bool is_leaf = false;     ///< one tree is a leaf rather than a node
};

class Collapse {
 public:
  Collapse(const std::vector<BinaryNode>& binary, const CollapseSource& source,
           std::vector<OpenChild>* open)
      : binary_(binary), source_(source), open_(open), costs_(binary.size()) {}

  Part run() {
    for (std::size_t i = binary_.size(); i-- > 0;) find_costs(i);
    part_.root = costs_[0].is_leaf && open_ == nullptr ? add_leaf(0) : add_node(0, 1);
    return std::move(part_);
  }

 private:
  /// Tests of blocks or entries in a leaf; more than any node where there is no such leaf.
  [[nodiscard]] double leaf_tests(std::size_t count) const {
    if (open_ != nullptr) return std::numeric_limits<double>::infinity();
    const bool of_triangles = source_.triangles != nullptr;
    const double tests = of_triangles ? block_count(count) : static_cast<double>(count);
    const double most = of_triangles ? source_.config.most_blocks : 1.0;
    return tests <= most ? tests : std::numeric_limits<double>::infinity();
  }

  /// Children come after their parents, so from the back all is known when it is needed.
  void find_costs(std::size_t i) {
    const BinaryNode& node = binary_[i];
    Costs& costs = costs_[i];
    const double area = node.range.box.half_area();
    if (node.is_leaf()) {
      costs.count = static_cast<std::uint32_t>(node.range.count);
      costs.is_leaf = true;
      // What is still open costs the same whatever it hangs from.
      const double cost = open_ != nullptr ? 0.0 : area * leaf_tests(costs.count);
      costs.forest.fill(static_cast<float>(cost));
      return;
    }
    const Costs& left = costs_[node.left];
    const Costs& right = costs_[node.right];
    costs.count = left.count + right.count;
    for (std::size_t trees = 2; trees <= k_width; ++trees) share(costs, left, right, trees);
    const double as_node =
        static_cast<double>(costs.forest[k_width - 1]) + area * source_.config.node_cost;
    const double as_leaf = area * leaf_tests(costs.count);
    costs.is_leaf = as_leaf <= as_node;
    costs.forest[0] = static_cast<float>(std::min(as_leaf, as_node));
    for (std::size_t t = 1; t + 1 < k_width; ++t) {
      if (costs.forest[t - 1] > costs.forest[t]) continue;
      costs.forest[t] = costs.forest[t - 1];
      costs.on_the_left[t] = 0;
    }
  }

  /// The best way to share so many trees between both sides.
  static void share(Costs& costs, const Costs& left, const Costs& right, std::size_t trees) {
    float least = std::numeric_limits<float>::infinity();
    std::size_t best = 1;
    for (std::size_t on_left = 1; on_left < trees; ++on_left) {
      const float cost = left.forest[on_left - 1] + right.forest[trees - on_left - 1];
      if (!(cost < least)) continue;
      least = cost;
      best = on_left;
    }
    costs.forest[trees - 1] = least;
    costs.on_the_left[trees - 1] = static_cast<std::uint8_t>(best);
  }

  /// The binary nodes that become the trees.
  void gather(std::uint32_t i, std::size_t trees, std::vector<std::uint32_t>& roots) const {
    while (trees > 1 && !binary_[i].is_leaf() && costs_[i].on_the_left[trees - 1] == 0) --trees;
    if (trees == 1 || binary_[i].is_leaf()) {
      roots.push_back(i);
      return;
    }
    const std::size_t on_left = costs_[i].on_the_left[trees - 1];
    gather(binary_[i].left, on_left, roots);
    gather(binary_[i].right, trees - on_left, roots);
  }

  std::uint32_t add_node(std::uint32_t i, std::size_t depth) {
    std::vector<std::uint32_t> roots;
    roots.reserve(k_width);
    if (binary_[i].is_leaf()) {
      roots.push_back(i);
    } else {
      const std::size_t on_left = costs_[i].on_the_left[k_width - 1];
      gather(binary_[i].left, on_left, roots);
      gather(binary_[i].right, k_width - on_left, roots);
    }
    // A ray that looks for any hit takes the first child first: the one it meets most likely.
    std::stable_sort(roots.begin(), roots.end(), [this](std::uint32_t a, std::uint32_t b) {
      return binary_[a].range.box.half_area() > binary_[b].range.box.half_area();
    });
    part_.depth = std::max(part_.depth, depth);
    part_.cost += binary_[i].range.box.half_area();
    const auto index = static_cast<std::uint32_t>(part_.nodes.size());
    part_.nodes.push_back(empty_node());
    for (std::uint32_t lane = 0; lane < roots.size(); ++lane) {
      const BinaryNode& root = binary_[roots[lane]];
      set_box(part_.nodes[index], lane, root.range.box);
      if (open_ != nullptr && root.is_leaf()) {
        open_->push_back({root.range, index, lane});
        open_->back().range.depth = depth;
        continue;
      }
      const std::uint32_t child =
          costs_[roots[lane]].is_leaf ? add_leaf(roots[lane]) : add_node(roots[lane], depth + 1);
      part_.nodes[index].child[lane] = child;
    }
    return index;
  }

  void gather_items(std::uint32_t i, std::vector<std::uint32_t>& items) const {
    if (binary_[i].is_leaf()) {
      for (const Reference& reference : binary_[i].range.references()) {
        items.push_back(reference.item);
      }
      return;
    }
    gather_items(binary_[i].left, items);
    gather_items(binary_[i].right, items);
  }

  std::uint32_t add_leaf(std::uint32_t i) {
    std::vector<std::uint32_t> items;
    items.reserve(costs_[i].count);
    gather_items(i, items);
    // Of an item that was cut, two parts may have come together again.
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    ++part_.leaf_count;
    part_.reference_count += items.size();
    part_.cost += binary_[i].range.box.half_area() * static_cast<double>(items.size());
    if (source_.triangles == nullptr) {
      const auto first = static_cast<std::uint32_t>(part_.entries.size());
      part_.entries.insert(part_.entries.end(), items.begin(), items.end());
      return Child::leaf(first, static_cast<std::uint32_t>(items.size()));
    }
    const auto first = static_cast<std::uint32_t>(part_.blocks.size());
    for (std::size_t k = 0; k < items.size(); k += TriangleBlock::k_size) {
      const std::size_t size = std::min(items.size() - k, TriangleBlock::k_size);
      part_.blocks.push_back(make_block(*source_.triangles, {items.data() + k, size}));
    }
    return Child::leaf(first, static_cast<std::uint32_t>(part_.blocks.size()) - first);
  }

  static Node empty_node() {
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    Node node;
    for (int row = 0; row < 6; ++row) {
      std::fill_n(node.planes[row], k_width, row % 2 == 0 ? k_infinity : -k_infinity);
    }
    std::fill_n(node.child, k_width, Child::leaf(0, 1));
    return node;
  }

  static void set_box(Node& node, std::uint32_t lane, const Box& box) {
    alignas(16) float lower[4];
    alignas(16) float upper[4];
    _mm_store_ps(lower, box.lower);
    _mm_store_ps(upper, box.upper);
    for (int axis = 0; axis < 3; ++axis) {
      node.planes[2 * axis][lane] = lower[axis];
      node.planes[2 * axis + 1][lane] = upper[axis];
    }
  }

  const std::vector<BinaryNode>& binary_;
  const CollapseSource& source_;
  std::vector<OpenChild>* open_;
  std::vector<Costs> costs_;
  Part part_;
};

}  // namespace

TriangleBlock make_block(const TriangleItems& triangles, std::span<const std::uint32_t> items) {
  TriangleBlock block;
  const Vec3 nowhere(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t lane = 0; lane < TriangleBlock::k_size; ++lane) {
    const bool is_there = lane < items.size();
    block.item[lane] = is_there ? items[lane] : 0;
    const auto corners =
        is_there ? triangles.corners(items[lane]) : std::array{nowhere, nowhere, nowhere};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) block.corner[corner][axis][lane] = corners[corner][axis];
    }
  }
  return block;
}

Part collapse(const std::vector<BinaryNode>& binary, const CollapseSource& source,
              std::vector<OpenChild>* open) {
  return Collapse(binary, source, open).run();
}

}  // namespace lume::geometry::wide
