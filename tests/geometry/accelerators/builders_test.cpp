// SPDX-License-Identifier: Apache-2.0
// Whatever the items, builders of bounding volume hierarchies make whole trees that are not too
// deep.
#include "tests/geometry/accelerators/bvh_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace lume::geometry::bvh {
namespace {

using test::k_bvh_builders;
using test::long_diagonals;
using test::object_of;
using test::Random;

/// Items that are boxes and nothing else.
class BoxItems final : public Items {
 public:
  explicit BoxItems(std::vector<Bounds> boxes) { bounds_ = std::move(boxes); }
};

bool contains(const Bounds& outer, const Bounds& inner) {
  return outer.contains(inner.lower) && outer.contains(inner.upper);
}

/// A tree's nodes are reached once each and hold each other, and leaves hold the ranges of
/// references in turn. Returns how often each item is referred to.
std::vector<int> expect_whole_tree(const BinaryTree& tree, const Items& items) {
  std::vector<int> uses(items.size(), 0);
  std::size_t nodes = 0;
  std::uint32_t next_reference = 0;
  std::vector<std::uint32_t> waiting;
  if (!tree.nodes.empty()) waiting.push_back(0);
  while (!waiting.empty()) {
    const std::uint32_t index = waiting.back();
    const Node<Bounds>& node = tree.nodes[index];
    waiting.pop_back();
    ++nodes;
    if (node.is_leaf()) {
      EXPECT_EQ(node.first, next_reference);
      next_reference += node.count;
      for (std::uint32_t i = node.first; i < next_reference; ++i) ++uses[tree.references[i]];
      continue;
    }
    EXPECT_GT(node.first, index);
    for (const std::uint32_t child : {node.first + 1, node.first}) {
      EXPECT_TRUE(contains(node.volume, tree.nodes[child].volume));
      waiting.push_back(child);
    }
  }
  EXPECT_EQ(nodes, tree.nodes.size());
  EXPECT_EQ(next_reference, tree.references.size());
  EXPECT_LE(depth(tree.nodes), k_max_depth);
  return uses;
}

void expect_leaves_hold_items(const BinaryTree& tree, const Items& items) {
  for (const Node<Bounds>& node : tree.nodes) {
    for (std::uint32_t i = node.first; node.is_leaf() && i < node.first + node.count; ++i) {
      EXPECT_TRUE(contains(node.volume, items.bounds(tree.references[i])));
    }
  }
}

/// Of triangles that were cut: every point of each is in a leaf that refers to it.
void expect_leaves_cover_items(const BinaryTree& tree, const TriangleItems& items, Random& random) {
  std::vector<std::vector<Bounds>> leaves(items.size());
  for (const Node<Bounds>& node : tree.nodes) {
    for (std::uint32_t i = node.first; node.is_leaf() && i < node.first + node.count; ++i) {
      leaves[tree.references[i]].push_back(node.volume);
    }
  }
  for (std::uint32_t item = 0; item < items.size(); ++item) {
    const auto corners = items.corners(item);
    for (int i = 0; i < 10; ++i) {
      const auto u = static_cast<double>(random.uniform());
      const double v = (1.0 - u) * static_cast<double>(random.uniform());
      const DVec3 p =
          (1.0 - u - v) * DVec3(corners[0]) + u * DVec3(corners[1]) + v * DVec3(corners[2]);
      const auto holds = [&p](const Bounds& box) {
        return DBounds{DVec3(box.lower) - 1e-14, DVec3(box.upper) + 1e-14}.contains(p);
      };
      EXPECT_TRUE(std::any_of(leaves[item].begin(), leaves[item].end(), holds)) << "item " << item;
    }
  }
}

TEST(BvhBuilders, AnyNumberOfItems_AreAllInTheTree) {
  Random random(1);
  for (const std::size_t count : {0u, 1u, 2u, 3u, 5u, 8u, 9u, 33u, 200u, 3000u}) {
    const Object object = object_of(long_diagonals(random, count));
    const TriangleItems items(object);
    for (const auto& [name, build, cuts_items] : k_bvh_builders) {
      SCOPED_TRACE(std::string(name) + " of " + std::to_string(items.size()));
      const BinaryTree tree = build(items);
      const std::vector<int> uses = expect_whole_tree(tree, items);
      EXPECT_EQ(tree.nodes.empty(), items.size() == 0);
      if (cuts_items) {
        EXPECT_TRUE(std::all_of(uses.begin(), uses.end(), [](int n) { return n >= 1; }));
        EXPECT_LE(static_cast<double>(tree.references.size()), k_most_references * items.size());
        expect_leaves_cover_items(tree, items, random);
      } else {
        EXPECT_TRUE(std::all_of(uses.begin(), uses.end(), [](int n) { return n == 1; }));
        expect_leaves_hold_items(tree, items);
      }
    }
  }
}

/// Boxes that no plane parts well.
std::vector<std::vector<Bounds>> hard_boxes() {
  std::vector<std::vector<Bounds>> lists(5);
  const float largest = std::numeric_limits<float>::max();
  for (int i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(i);
    lists[0].push_back({Vec3(1.0f), Vec3(2.0f)});  // the same
    lists[1].push_back({Vec3(-x), Vec3(x)});       // around one middle
    lists[2].push_back({Vec3(3.0f), Vec3(3.0f)});  // one point
    lists[3].push_back({Vec3(-largest), Vec3(i % 2 == 0 ? largest : -largest)});
  }
  // Points in clusters towards the origin along three axes, each at half the distance of the one
  // before: a tree that sees only areas is as deep as there are clusters.
  for (int i = 0; i < 3 * 250 * 12; ++i) {
    const float distance = std::ldexp(1.0f, i / 36 - 125);
    Vec3 point(0.0f);
    point[i % 3] = distance * (1.0f + 0.05f * static_cast<float>(i / 3 % 12));
    lists[4].push_back({point, point});
  }
  return lists;
}

TEST(BvhBuilders, HardBoxes_StillMakeTreesThatAreNotTooDeep) {
  for (const std::vector<Bounds>& boxes : hard_boxes()) {
    const BoxItems items(boxes);
    for (const auto& [name, build, cuts_items] : k_bvh_builders) {
      SCOPED_TRACE(name);
      const BinaryTree tree = build(items);
      expect_whole_tree(tree, items);
      for (const Node<Bounds>& node : tree.nodes) EXPECT_LE(node.count, k_most_in_leaf);
      EXPECT_TRUE(std::isfinite(sah_cost(tree.nodes)));
    }
  }
}

}  // namespace
}  // namespace lume::geometry::bvh
