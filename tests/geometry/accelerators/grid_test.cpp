// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/grid/grid.h"

#include "tests/geometry/accelerators/structure_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lume::geometry {
namespace {

using grid::Cell;
using grid::Lattice;
using grid::LatticeWalk;
using test::Random;

TEST(Grid, MixedWorlds_MeetWhatBruteForceMeets) { test::expect_agreement_in_mixed_worlds("grid"); }

TEST(Grid, TiedWorlds_MeetTheLowestIdentity) { test::expect_agreement_in_tied_worlds("grid"); }

TEST(Grid, Holes_AreLetThrough) { test::expect_agreement_beside_holes("grid"); }

TEST(Grid, HardMeshes_MeetWhatBruteForceMeets) { test::expect_agreement_in_hard_meshes("grid"); }

TEST(Grid, WorldsWithoutTriangles_MeetTheirShapesOrNothing) {
  test::expect_shapes_alone_are_met("grid");
}

/// Items that are boxes and nothing more.
class BoxItems final : public Items {
 public:
  void add(const Bounds& bounds) { bounds_.push_back(bounds); }
};

/// Small boxes in a random large one, here and there without a size along an axis.
BoxItems& fill(BoxItems& items, Random& random) {
  Vec3 size(random.uniform(1.0f, 10.0f), random.uniform(1.0f, 10.0f), random.uniform(1.0f, 10.0f));
  if (random.below(3) == 0) size[static_cast<int>(random.below(3))] = 0.0f;
  const Vec3 middle = random.cube(5.0f);
  const std::uint32_t count = 1 + random.below(200);
  for (std::uint32_t i = 0; i < count; ++i) {
    Bounds bounds;
    bounds.add(middle + size * random.cube(0.5f));
    items.add(bounds);
  }
  return items;
}

/// Cells, by place in memory, whose box the ray meets when it is made larger by `margin` of a cell:
/// three intervals of t, found by division for every cell there is.
std::set<std::size_t> enumerate(const Lattice& lattice, const Ray& ray, double margin) {
  std::set<std::size_t> result;
  const DVec3 lowest(lattice.all().lower);
  const DVec3 highest(lattice.all().upper);
  for (int z = 0; z < lattice.count(2); ++z) {
    for (int y = 0; y < lattice.count(1); ++y) {
      for (int x = 0; x < lattice.count(0); ++x) {
        const Cell cell(x, y, z);
        double enter = ray.t_min;
        double leave = ray.t_max;
        for (int axis = 0; axis < 3; ++axis) {
          const bool is_cut = lattice.count(axis) > 1;
          const double first = is_cut ? lattice.plane(axis, cell[axis]) : lowest[axis];
          const double last = is_cut ? lattice.plane(axis, cell[axis] + 1) : highest[axis];
          const double wider = is_cut ? margin * (last - first) : 1e-9;
          const double a = (first - wider - ray.origin[axis]) / ray.direction[axis];
          const double b = (last + wider - ray.origin[axis]) / ray.direction[axis];
          enter = std::max(enter, std::min(a, b));
          leave = std::min(leave, std::max(a, b));
        }
        if (enter <= leave) result.insert(lattice.index(cell));
      }
    }
  }
  return result;
}

std::vector<std::size_t> walk_through(const Lattice& lattice, const Ray& ray) {
  const ObjectRay object_ray{DVec3(ray.origin), DVec3(ray.direction), ray.t_min, ray.t_max};
  EXPECT_TRUE(lattice.is_fine_for(object_ray));
  const SlabRay slabs(object_ray, lattice.all());
  const Interval1D inside = slabs.clip(lattice.all(), ray.t_min, ray.t_max);
  std::vector<std::size_t> cells;
  if (inside.is_empty()) return cells;
  LatticeWalk walk(lattice, object_ray, slabs, inside.enter);
  do {
    EXPECT_EQ(walk.index(), lattice.index(walk.cell()));
    cells.push_back(walk.index());
  } while (walk.advance(inside.leave));
  return cells;
}

TEST(LatticeWalk, RandomRays_EnterTheCellsOfAnEnumeration) {
  Random random(1);
  std::size_t entered = 0;
  for (int round = 0; round < test::cases(300); ++round) {
    BoxItems items;
    const Lattice lattice(fill(items, random), random.uniform(0.5f, 4.0f));
    for (int i = 0; i < 40; ++i) {
      const Ray ray = test::random_ray(random, 8.0f);
      const std::vector<std::size_t> cells = walk_through(lattice, ray);
      const std::set<std::size_t> once(cells.begin(), cells.end());
      EXPECT_EQ(once.size(), cells.size()) << "a cell was entered twice";
      // The lattice reaches beyond its items by a margin, where no walk has to go.
      const auto must = enumerate(lattice, ray, -1.01 * Lattice::k_margin);
      const auto may = enumerate(lattice, ray, 1e-9);
      EXPECT_TRUE(std::includes(once.begin(), once.end(), must.begin(), must.end()));
      EXPECT_TRUE(std::includes(may.begin(), may.end(), once.begin(), once.end()));
      entered += cells.size();
      if (HasFailure()) FAIL() << "round " << round << ", ray " << i;
    }
  }
  EXPECT_GT(entered, static_cast<std::size_t>(test::cases(5000)));
}

TEST(LatticeWalk, RaysThroughAllCorners_EnterACellOfEachItem) {
  // Items are points on the cells' corners and in the planes between them; rays run through these.
  BoxItems items;
  for (int i = 0; i <= 4; ++i)
    items.add({Vec3(static_cast<float>(i)), Vec3(static_cast<float>(i))});
  const Lattice lattice(items, 100.0);
  for (const Vec3 sign : {Vec3(1, 1, 1), Vec3(-1, -1, -1)}) {
    const Ray ray{.origin = Vec3(2.0f) - 7.0f * sign, .direction = sign};
    const std::vector<std::size_t> cells = walk_through(lattice, ray);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      const grid::CellRange touched = lattice.touched_by(items.bounds(i));
      const bool found = std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) {
        return cell == lattice.index(touched.first) || cell == lattice.index(touched.last);
      });
      EXPECT_TRUE(found) << "item " << i;
    }
  }
}

TEST(Lattice, CellsOfBoxes_HoldTheirPoints) {
  Random random(2);
  for (int round = 0; round < 100; ++round) {
    BoxItems items;
    const Lattice lattice(fill(items, random), 4.0);
    EXPECT_LE(lattice.count(), 4 * items.size() + 1);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      const Vec3 point = items.bounds(i).lower;
      const Cell cell = lattice.cell_at(DVec3(point));
      EXPECT_TRUE(lattice.bounds(cell).contains(point));
      const auto [first, last] = lattice.touched_by(items.bounds(i));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(first, cell)));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(cell, last)));
    }
  }
}

TEST(Lattice, EvenlyFilledBox_IsCutIntoCubes) {
  BoxItems items;
  for (int i = 0; i < 500; ++i) items.add({Vec3(0.0f), Vec3(8.0f, 4.0f, 2.0f)});
  const Lattice lattice(items, 1.0 * 512 / 500);  // 512 cells for a volume of 64: half a unit each
  EXPECT_NEAR(lattice.count(0), 16, 1);
  EXPECT_NEAR(lattice.count(1), 8, 1);
  EXPECT_NEAR(lattice.count(2), 4, 1);
}

TEST(Grid, Stats_SayWhatItIsMadeOf) {
  World world;
  test::add_instance(world, test::sphere_mesh(32));  // 3,968 triangles
  const StructureStats stats = make_accelerator("grid", world, nullptr)->stats().structure;
  // Two grids, that of the triangles and that of the instance, which is one cell.
  EXPECT_GT(stats.nodes, 3968u);
  EXPECT_LE(stats.nodes, 4u * 3968u + 1u);
  EXPECT_GT(stats.leaves, 1000u);
  EXPECT_LT(stats.leaves, stats.nodes);
  EXPECT_EQ(stats.depth, 1u);
  EXPECT_GT(stats.references, 3969u);
  EXPECT_LT(stats.references, 3968u * 6);
  EXPECT_EQ(stats.sah_cost, 0.0);
  EXPECT_EQ(stats.memory_bytes, 4 * (stats.nodes + 2 + stats.references));
}

TEST(Grid, LongTriangles_DoNotFillTheMemory) {
  Random random(5);
  World world;
  test::add_instance(world, test::triangle_soup(random, 3000, 1.0f, 1.0f));
  const StructureStats stats = make_accelerator("grid", world, nullptr)->stats().structure;
  EXPECT_LE(stats.references, 64u * 3000u + 1u);
}

TEST(Grid, Counting_SaysHowLittleIsLookedAt) {
  World world;
  test::add_instance(world, test::sphere_mesh(100));  // 39,600 triangles
  const auto accelerator = make_accelerator("grid", world, nullptr);
  const Ray ray{.origin = {0.1f, 0.2f, 3.0f}};
  TraversalCost cost;
  EXPECT_EQ(accelerator->closest_hit_counted(ray, cost), accelerator->closest_hit(ray));
  EXPECT_GE(cost.nodes, 2u);
  EXPECT_LE(cost.nodes, 60u);  // of 54 cells or so along an axis
  EXPECT_GE(cost.primitive_tests, 1u);
  EXPECT_LE(cost.primitive_tests, 60u);
}

}  // namespace
}  // namespace lume::geometry
