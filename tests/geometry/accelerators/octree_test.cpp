// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/octree/octree.h"

#include "tests/geometry/accelerators/structure_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lume::geometry {
namespace {

using octree::Octree;
using test::Random;

TEST(Octree, MixedWorlds_MeetWhatBruteForceMeets) {
  test::expect_agreement_in_mixed_worlds("octree");
}

TEST(Octree, TiedWorlds_MeetTheLowestIdentity) { test::expect_agreement_in_tied_worlds("octree"); }

TEST(Octree, Holes_AreLetThrough) { test::expect_agreement_beside_holes("octree"); }

TEST(Octree, HardMeshes_MeetWhatBruteForceMeets) {
  test::expect_agreement_in_hard_meshes("octree");
}

TEST(Octree, WorldsWithoutTriangles_MeetTheirShapesOrNothing) {
  test::expect_shapes_alone_are_met("octree");
}

/// Points, which are items without a size.
class PointItems final : public Items {
 public:
  PointItems(Random& random, int count) {
    for (int i = 0; i < count; ++i) {
      Bounds bounds;
      bounds.add(random.cube(1.0f));
      bounds_.push_back(bounds);
    }
  }
};

/// When a ray is nearest to a point.
double time_of(const ObjectRay& ray, const Vec3& point) {
  return dot(DVec3(point) - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
}

TEST(Octree, RaysThroughPoints_VisitThemFromFrontToBack) {
  // Of a cell of some points the last may come before the first of the next one, but never before
  // the cell itself: what is visited much too early or late was in the wrong place.
  Random random(1);
  const PointItems items(random, 4000);
  const Octree tree(items);
  for (int i = 0; i < test::cases(3000); ++i) {
    const Vec3 target = items.bounds(random.below(items.size())).lower;
    const DVec3 origin(random.cube(4.0f));
    const ObjectRay ray{origin, DVec3(target) - origin};
    double latest = 0.0;
    bool found = false;
    NoCost cost;
    tree.traverse(
        ray,
        [&](std::uint32_t item) {
          const Vec3 point = items.bounds(item).lower;
          const double t = time_of(ray, point);
          const double cell = 0.5 / length(ray.direction);  // cells are smaller than half a unit
          EXPECT_GT(t, latest - cell);
          latest = std::max(latest, t);
          found = found || point == target;
          return false;
        },
        cost);
    EXPECT_TRUE(found) << "ray " << i;
    if (HasFailure()) return;
  }
}

TEST(Octree, EndOfTheRay_IsWhereTheWalkEnds) {
  Random random(2);
  const PointItems items(random, 4000);
  const Octree tree(items);
  ObjectRay ray{DVec3(-5.0, 0.1, 0.2), DVec3(1.0, 0.0, 0.0)};
  const auto count_visits = [&](double t_max) {
    ray.t_max = t_max;
    std::set<std::uint32_t> visited;
    TraversalCost cost;
    tree.traverse(
        ray, [&](std::uint32_t item) { return !visited.insert(item).second; }, cost);
    return visited.size();
  };
  EXPECT_EQ(count_visits(3.9), 0u);
  const std::size_t half = count_visits(5.0);
  const std::size_t all = count_visits(7.0);
  EXPECT_GT(half, 3u);
  EXPECT_GT(all, half + 3);
  EXPECT_LT(all, 200u);
}

TEST(Octree, Stats_SayWhatATreeIsMadeOf) {
  World world;
  test::add_instance(world, test::sphere_mesh(32));  // 3,968 triangles
  const StructureStats stats = make_accelerator("octree", world, nullptr)->stats().structure;
  EXPECT_GT(stats.nodes, 100u);
  EXPECT_LE(stats.leaves, 7 * stats.nodes + 2);  // two trees; some leaves are empty
  EXPECT_GE(stats.depth, 4u);
  EXPECT_LE(stats.depth, 12u);
  EXPECT_GE(stats.references, 3969u);
  EXPECT_LE(stats.references, 3968u * 6u);
  EXPECT_GT(stats.sah_cost, 5.0);
  EXPECT_LT(stats.sah_cost, 200.0);
  EXPECT_GT(stats.memory_bytes, 24 * (stats.nodes + stats.leaves) + 4 * stats.references);
}

TEST(Octree, UncutWorld_CostsATestForEachItem) {
  Random random(3);
  const PointItems items(random, 5);
  const StructureStats stats = Octree(items).stats();
  EXPECT_EQ(stats.sah_cost, 5.0);
  EXPECT_EQ(stats.nodes, 0u);
  EXPECT_EQ(stats.leaves, 1u);
  EXPECT_EQ(stats.depth, 0u);
}

TEST(Octree, FlatWorld_HoldsEachPointOnce) {
  // The planes that lie in a flat world part nothing, and must not double what lies in them.
  Random random(4);
  Object object;
  object.geometries.push_back(
      {test::moved(test::triangle_soup(random, 2000, 1.0f, 1e-4f), {1.0f, 1.0f, 0.0f})});
  const TriangleItems items(object);
  const StructureStats stats = Octree(items).stats();
  EXPECT_GT(stats.depth, 4u);
  EXPECT_LT(stats.references, 2100u);
}

TEST(Octree, Counting_SaysHowLittleIsLookedAt) {
  World world;
  test::add_instance(world, test::sphere_mesh(100));  // 39,600 triangles
  const auto accelerator = make_accelerator("octree", world, nullptr);
  const Ray ray{.origin = {0.1f, 0.2f, 3.0f}};
  TraversalCost cost;
  EXPECT_EQ(accelerator->closest_hit_counted(ray, cost), accelerator->closest_hit(ray));
  EXPECT_GE(cost.nodes, 5u);
  EXPECT_LE(cost.nodes, 100u);
  EXPECT_GE(cost.primitive_tests, 1u);
  EXPECT_LE(cost.primitive_tests, 60u);
}

}  // namespace
}  // namespace lume::geometry
