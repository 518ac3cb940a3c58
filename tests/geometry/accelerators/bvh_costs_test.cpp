// SPDX-License-Identifier: Apache-2.0
// Each builder of bounding volume hierarchies has the virtue that it is named for.
#include "tests/geometry/accelerators/bvh_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lume::geometry::bvh {
namespace {

using test::k_bvh_builders;
using test::long_diagonals;
using test::object_of;
using test::Random;

TEST(BvhCosts, SahCost_IsThatOfTheFormula) {
  // A unit cube with a child of half its size that holds three items, and one of no size with two.
  BinaryTree tree;
  tree.nodes = {{{Vec3(0.0f), Vec3(1.0f)}, 1, 0},
                {{Vec3(0.0f), Vec3(0.5f)}, 0, 3},
                {{Vec3(1.0f), Vec3(1.0f)}, 3, 2}};
  EXPECT_EQ(sah_cost(tree.nodes), 1.0 + 0.25 * 3.0);
  EXPECT_EQ(depth(tree.nodes), 1u);
  EXPECT_EQ(sah_cost(std::vector<Node<Bounds>>()), 0.0);
}

TEST(BvhCosts, Median_IsBalanced) {
  Random random(2);
  for (const std::size_t count : {4u, 5u, 64u, 1000u, 4096u}) {
    const Object object = object_of(test::triangle_soup(random, count, 4.0f, 0.1f));
    const BinaryTree tree = build_median(TriangleItems(object));
    const double levels = std::ceil(std::log2(static_cast<double>(count) / 4.0));
    EXPECT_EQ(static_cast<double>(depth(tree.nodes)), levels) << count;
  }
}

/// The least cost of parting the items in two along an axis, by trying all ways anew.
double least_cost_of_two(const Items& items) {
  std::vector<std::uint32_t> order(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) order[i] = i;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return items.bounds(a).center()[axis] < items.bounds(b).center()[axis];
    });
    for (std::size_t cut = 1; cut < order.size(); ++cut) {
      Bounds sides[2];
      for (std::size_t i = 0; i < order.size(); ++i) {
        sides[i < cut ? 0 : 1].add(items.bounds(order[i]));
      }
      least = std::min(least, half_area(sides[0]) * static_cast<double>(cut) +
                                  half_area(sides[1]) * static_cast<double>(order.size() - cut));
    }
  }
  return least;
}

TEST(BvhCosts, Sweep_FindsTheBestOfAllCuts) {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    const Object object = object_of(test::triangle_soup(random, 10 + random.below(50), 4.0f, 1.0f));
    const TriangleItems items(object);
    const BinaryTree tree = build_sweep_sah(items);
    ASSERT_FALSE(tree.nodes[0].is_leaf());
    // Both children's references are one range each.
    std::uint32_t leaf = tree.nodes[0].first + 1;
    while (!tree.nodes[leaf].is_leaf()) leaf = tree.nodes[leaf].first;
    const double first_count = tree.nodes[leaf].first;
    const double cost =
        half_area(tree.nodes[1].volume) * first_count +
        half_area(tree.nodes[2].volume) * (static_cast<double>(items.size()) - first_count);
    EXPECT_NEAR(cost, least_cost_of_two(items), 1e-6 * cost);
  }
}

TEST(BvhCosts, Costs_AreInTheOrderOfTheEffort) {
  Random random(4);
  for (int round = 0; round < 5; ++round) {
    Mesh mesh = test::sphere_mesh(20);
    test::add_mesh(mesh, test::triangle_soup(random, 1000, 2.0f, 0.2f));
    const Object object = object_of(mesh);
    const TriangleItems items(object);
    const auto cost = [&](auto* build) { return sah_cost(build(items).nodes); };
    const double binned = cost(build_binned_sah);
    EXPECT_LE(cost(build_sweep_sah), 1.02 * binned);
    EXPECT_LT(binned, 0.95 * cost(build_lbvh));
    EXPECT_LT(binned, 0.95 * cost(build_median));
  }
}

TEST(BvhCosts, Reinsertion_LowersTheCostOfEveryTree) {
  Random random(5);
  const Object object = object_of(long_diagonals(random, 2000));
  const TriangleItems items(object);
  for (const auto& [name, build, cuts_items] : k_bvh_builders) {
    if (name == "reinsert") continue;
    const BinaryTree before = build(items);
    const BinaryTree after = reinsert(before);
    const double part = sah_cost(after.nodes) / sah_cost(before.nodes);
    EXPECT_LT(part, name == "spatial" ? 1.0 : 0.96) << name;
    EXPECT_EQ(after.nodes.size(), before.nodes.size()) << name;
    std::vector<std::uint32_t> references = after.references;
    std::vector<std::uint32_t> expected = before.references;
    std::sort(references.begin(), references.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(references, expected) << name;
  }
}

TEST(BvhCosts, SpatialSplits_HalveTheCostOfLongDiagonals) {
  Random random(6);
  const Object object = object_of(long_diagonals(random, 3000));
  const TriangleItems items(object);
  const double sweep = sah_cost(build_sweep_sah(items).nodes);
  EXPECT_LT(sah_cost(build_spatial_splits(items).nodes), 0.6 * sweep);
}

TEST(BvhCosts, TeapotInAStadium_IsFoundByTheSah) {
  // Ten thousand small triangles in a thousandth of a hall of a hundred large ones.
  Random random(7);
  Mesh mesh = test::triangle_soup(random, 100, 500.0f, 100.0f);
  test::add_mesh(mesh, test::triangle_soup(random, 10000, 0.5f, 0.01f));
  const Object object = object_of(mesh);
  const TriangleItems items(object);
  // A ray through the hall hardly ever comes near the teapot.
  EXPECT_LT(sah_cost(build_binned_sah(items).nodes), 60.0);
  EXPECT_LT(sah_cost(build_sweep_sah(items).nodes), 60.0);
}

TEST(Morton, Codes_AreInterleavedBitByBit) {
  Random random(8);
  for (int i = 0; i < 10000; ++i) {
    const std::uint32_t cell[3] = {random.below(1u << 21u), random.below(1u << 21u),
                                   random.below(1u << 21u)};
    std::uint64_t expected = 0;
    for (unsigned bit = 0; bit < 21; ++bit) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        const std::uint64_t value = cell[axis] >> bit & 1u;
        expected |= value << (3 * bit + 2 - axis);
      }
    }
    EXPECT_EQ(morton_code(cell[0], cell[1], cell[2]), expected);
  }
  EXPECT_EQ(morton_code(0x1f'ffff, 0x1f'ffff, 0x1f'ffff), 0x7fff'ffff'ffff'ffffu);
}

}  // namespace
}  // namespace lume::geometry::bvh
