// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/kd_tree/kd_tree.h"

#include "geometry/accelerators/kd_tree/split.h"
#include "tests/geometry/accelerators/structure_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lume::geometry {
namespace {

using kd_tree::Event;
using kd_tree::EventLists;
using kd_tree::Plane;
using kd_tree::Split;
using test::Random;

TEST(KdTree, MixedWorlds_MeetWhatBruteForceMeets) {
  test::expect_agreement_in_mixed_worlds("kd-tree");
}

TEST(KdTree, TiedWorlds_MeetTheLowestIdentity) { test::expect_agreement_in_tied_worlds("kd-tree"); }

TEST(KdTree, Holes_AreLetThrough) { test::expect_agreement_beside_holes("kd-tree"); }

TEST(KdTree, HardMeshes_MeetWhatBruteForceMeets) {
  test::expect_agreement_in_hard_meshes("kd-tree");
}

TEST(KdTree, WorldsWithoutTriangles_MeetTheirShapesOrNothing) {
  test::expect_shapes_alone_are_met("kd-tree");
}

/// Boxes in a cube, on whole numbers and flat now and then, so that many planes fall together.
std::vector<Bounds> random_boxes(Random& random) {
  std::vector<Bounds> boxes(2 + random.below(20));
  const bool whole = random.below(2) == 0;
  for (Bounds& box : boxes) {
    const Vec3 a = random.cube(5.0f);
    Vec3 b = a + random.cube(2.0f);
    for (int axis = 0; axis < 3; ++axis) {
      if (random.below(4) == 0) b[axis] = a[axis];
    }
    box.add(whole ? glm::round(a) : a);
    box.add(whole ? glm::round(b) : b);
  }
  return boxes;
}

double surface(const Bounds& box) {
  const DVec3 size = DVec3(box.upper) - DVec3(box.lower);
  return 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

/// What a plane costs, by looking at every box.
double cost_of(const std::vector<Bounds>& boxes, const Bounds& all, const Plane& plane,
               std::size_t& cut_count) {
  const int axis = plane.axis;
  std::size_t left = 0;
  std::size_t right = 0;
  for (const Bounds& box : boxes) {
    const bool in_plane = box.lower[axis] == plane.place && box.upper[axis] == plane.place;
    if (in_plane ? plane.planar_left : box.lower[axis] < plane.place) ++left;
    if (in_plane ? !plane.planar_left : box.upper[axis] > plane.place) ++right;
  }
  cut_count = left + right - boxes.size();
  Bounds below = all;
  Bounds above = all;
  below.upper[axis] = above.lower[axis] = plane.place;
  const double tests =
      (surface(below) * static_cast<double>(left) + surface(above) * static_cast<double>(right)) /
      surface(all);
  const double cost = 1.0 + kd_tree::k_test_cost * tests;
  return left == 0 || right == 0 ? kd_tree::k_empty_bonus * cost : cost;
}

double cheapest_cost(const std::vector<Bounds>& boxes, const Bounds& all, std::size_t spare) {
  double best = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (const Bounds& box : boxes) {
      for (const float place : {box.lower[axis], box.upper[axis]}) {
        if (place == all.lower[axis] || place == all.upper[axis]) continue;
        for (const bool planar_left : {false, true}) {
          std::size_t cut_count = 0;
          const double cost = cost_of(boxes, all, {axis, place, planar_left}, cut_count);
          if (cut_count <= spare) best = std::min(best, cost);
        }
      }
    }
  }
  return best;
}

TEST(KdSplit, RandomBoxes_AreCutWhereItIsCheapest) {
  Random random(1);
  int found = 0;
  for (int i = 0; i < test::cases(20000); ++i) {
    const std::vector<Bounds> boxes = random_boxes(random);
    Bounds all;
    EventLists events;
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      all.add(boxes[k]);
      events.add(k, boxes[k]);
    }
    if (!(surface(all) > 0.0)) continue;
    events.sort();
    const std::size_t spare = random.below(2) == 0 ? random.below(4) : boxes.size();
    const Split split = kd_tree::find_split(events, all, spare);
    const double expected = cheapest_cost(boxes, all, spare);
    if (std::isinf(expected)) {
      EXPECT_EQ(split.cost, expected);
      continue;
    }
    ++found;
    std::size_t cut_count = 0;
    EXPECT_NEAR(split.cost, expected, 1e-12 * expected);
    EXPECT_NEAR(cost_of(boxes, all, split.plane, cut_count), expected, 1e-12 * expected);
    EXPECT_EQ(split.left + split.right, boxes.size() + cut_count);
    EXPECT_LE(cut_count, spare);
    if (HasFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(found, test::cases(10000));
}

/// One triangle after the other, cut by hand and sorted anew.
std::pair<EventLists, EventLists> divide_slowly(const Items& items, const Bounds& all,
                                                const Plane& plane) {
  std::pair<EventLists, EventLists> result;
  const auto [left_box, right_box] = kd_tree::cut(all, plane);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const Bounds& box = items.bounds(i);
    const float lower = box.lower[plane.axis];
    const float upper = box.upper[plane.axis];
    const bool in_plane = lower == plane.place && upper == plane.place;
    if (in_plane ? plane.planar_left : upper <= plane.place) {
      result.first.add(i, box);
    } else if (lower >= plane.place) {
      result.second.add(i, box);
    } else {
      const Bounds left = items.clipped(i, left_box);
      const Bounds right = items.clipped(i, right_box);
      if (!left.is_empty()) result.first.add(i, left);
      if (!right.is_empty()) result.second.add(i, right);
    }
  }
  result.first.sort();
  result.second.sort();
  return result;
}

void expect_same(const EventLists& a, const EventLists& b) {
  EXPECT_EQ(a.count, b.count);
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_EQ(a.of_axis[axis].size(), b.of_axis[axis].size());
    for (std::size_t i = 0; i < a.of_axis[axis].size(); ++i) {
      const Event& event = a.of_axis[axis][i];
      const Event& expected = b.of_axis[axis][i];
      EXPECT_EQ(event.place, expected.place);
      EXPECT_EQ(event.item, expected.item);
      EXPECT_EQ(event.kind, expected.kind);
    }
  }
}

TEST(KdDivider, EventsOfBothSides_AreThoseThatSortingWouldGive) {
  Random random(2);
  for (int i = 0; i < test::cases(2000); ++i) {
    Object object;
    Mesh mesh = test::triangle_soup(random, 1 + random.below(30), 3.0f, 2.0f);
    if (random.below(2) == 0) {
      for (Vec3& p : mesh.positions) p = glm::round(p);
    }
    object.geometries.push_back({mesh});
    const TriangleItems items(object);
    EventLists events;
    for (std::uint32_t k = 0; k < items.size(); ++k) events.add(k, items.bounds(k));
    events.sort();
    const int axis = static_cast<int>(random.below(3));
    const std::vector<Event>& list = events.of_axis[axis];
    const Event& event = list[random.below(static_cast<std::uint32_t>(list.size()))];
    const Plane plane{axis, event.place, random.below(2) == 0};
    const Bounds all = items.all_bounds();
    kd_tree::Divider divider(items);
    // Twice, for a divider must not remember the first time.
    for (int time = 0; time < 2; ++time) {
      const auto [left, right] = divider.divide(events, all, plane);
      const auto [expected_left, expected_right] = divide_slowly(items, all, plane);
      expect_same(left, expected_left);
      expect_same(right, expected_right);
    }
    if (HasFailure()) FAIL() << "case " << i;
  }
}

TEST(KdTree, Stats_SayWhatATreeIsMadeOf) {
  World world;
  test::add_instance(world, test::sphere_mesh(32));  // 3,968 triangles
  const StructureStats stats = make_accelerator("kd-tree", world, nullptr)->stats().structure;
  EXPECT_GT(stats.nodes, 1000u);
  EXPECT_LE(stats.leaves, stats.nodes + 2);  // two trees; some leaves are empty
  EXPECT_GE(stats.depth, 10u);
  EXPECT_LE(stats.depth, 8u + 16u);
  EXPECT_GE(stats.references, 3969u);
  EXPECT_LE(stats.references, 3968u * 9u + 1u);
  EXPECT_GT(stats.sah_cost, 5.0);
  EXPECT_LT(stats.sah_cost, 100.0);
  EXPECT_GT(stats.memory_bytes, 12 * (stats.nodes + stats.leaves) + 4 * stats.references);
}

TEST(KdTree, SahCost_IsWhatRaysThroughTheBoxFind) {
  // Rays that are spread evenly over all lines through the box enter as many inner nodes, and meet
  // as many items in leaves, as the heuristic expects; a ray must not end before it has left.
  Random random(3);
  Object object;
  object.geometries.push_back({test::triangle_soup(random, 300, 3.0f, 0.5f)});
  const TriangleItems items(object);
  const kd_tree::KdTree tree(items);
  const Bounds all = items.all_bounds();
  const auto radius = static_cast<double>(all.radius());
  TraversalCost cost;
  int rays = 0;
  while (rays < test::cases(40000)) {
    // Lines at right angles to a random direction's disk, which are as many through each point.
    const Vec3 direction = random.direction();
    const Frame frame = make_frame(direction);
    const Vec2 aside = (2.0f * random.square() - 1.0f) * static_cast<float>(radius);
    const Vec3 start = all.center() + frame.to_world({aside, -10.0f * static_cast<float>(radius)});
    const ObjectRay ray{DVec3(start), DVec3(direction)};
    if (SlabRay(ray, all).clip(all, 0.0, 1e9).is_empty()) continue;
    ++rays;
    const auto visit = [&](std::uint32_t) {
      cost.add_test();
      return false;
    };
    tree.traverse(ray, visit, cost);
  }
  // Items that a ray meets in several leaves are tested once, so the cost is a little less.
  const double expected = tree.stats().sah_cost;
  const double found = static_cast<double>(cost.nodes + cost.primitive_tests) / rays;
  EXPECT_LT(found, 1.02 * expected);
  EXPECT_GT(found, 0.75 * expected);
}

TEST(KdTree, Counting_SaysHowLittleIsLookedAt) {
  World world;
  test::add_instance(world, test::sphere_mesh(100));  // 39,600 triangles
  const auto accelerator = make_accelerator("kd-tree", world, nullptr);
  const Ray ray{.origin = {0.1f, 0.2f, 3.0f}};
  TraversalCost cost;
  EXPECT_EQ(accelerator->closest_hit_counted(ray, cost), accelerator->closest_hit(ray));
  EXPECT_GE(cost.nodes, 10u);
  EXPECT_LE(cost.nodes, 100u);
  EXPECT_GE(cost.primitive_tests, 1u);
  EXPECT_LE(cost.primitive_tests, 20u);
}

}  // namespace
}  // namespace lume::geometry
