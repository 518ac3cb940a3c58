// SPDX-License-Identifier: Apache-2.0
// Every bounding volume hierarchy against brute force: the same primitive for every ray, in worlds
// of every kind.
#include "tests/geometry/accelerators/bvh_builders.h"
#include "tests/support/agreement.h"
#include "tests/support/cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lume::geometry {
namespace {

using test::add_triangle;
using test::Random;

constexpr std::string_view k_names[] = {"bvh-median",  "bvh-sah",      "bvh-sweep",   "bvh-lbvh",
                                        "bvh-spatial", "bvh-reinsert", "sphere-tree", "obb-tree"};

/// As test::expect_agreement, of all these structures at once: brute force is what takes the time.
int expect_all_agree(const World& world, const HoleTest* holes, int count,
                     const std::function<Ray()>& make_ray) {
  std::vector<std::unique_ptr<Accelerator>> accelerators;
  for (const std::string_view name : k_names) {
    accelerators.push_back(make_accelerator(name, world, holes));
  }
  const auto oracle = make_accelerator("brute-force", world, holes);
  int hits = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const Ray ray = make_ray();
    const auto expected = oracle->closest_hit(ray);
    for (std::size_t k = 0; k < accelerators.size(); ++k) {
      EXPECT_EQ(accelerators[k]->closest_hit(ray), expected) << k_names[k] << ", ray " << i;
      EXPECT_EQ(accelerators[k]->any_hit(ray), expected.has_value()) << k_names[k] << ", ray " << i;
    }
    if (expected) ++hits;
  }
  return hits;
}

TEST(Bvh, MixedWorlds_MeetWhatBruteForceMeets) {
  Random random(1);
  int hits = 0;
  for (int round = 0; round < 10; ++round) {
    const World world = test::mixed_world(random);
    hits += expect_all_agree(world, nullptr, test::cases(1500),
                             [&] { return test::random_ray(random); });
    hits +=
        expect_all_agree(world, nullptr, test::cases(500), [&] { return test::axis_ray(random); });
  }
  EXPECT_GT(hits, test::cases(4000));
}

TEST(Bvh, TiedWorlds_MeetTheLowestIdentity) {
  Random random(2);
  int hits = 0;
  for (int round = 0; round < 20; ++round) {
    const World world = test::tied_world(random);
    hits += expect_all_agree(world, nullptr, test::cases(2000),
                             [&] { return test::random_ray(random); });
    hits +=
        expect_all_agree(world, nullptr, test::cases(2000), [&] { return test::axis_ray(random); });
  }
  EXPECT_GT(hits, test::cases(4000));
}

/// A hole wherever the first coordinate is below a half.
class HalfHoles final : public HoleTest {
 public:
  bool is_hole(const Hit&, Vec2 uv) const override { return uv.x < 0.5f; }
};

TEST(Bvh, Holes_AreLetThrough) {
  Random random(3);
  const HalfHoles holes;
  int hits = 0;
  for (int round = 0; round < 10; ++round) {
    World world = test::mixed_world(random);
    for (Object& object : world.objects) object.geometries[0].has_holes = true;
    hits += expect_all_agree(world, &holes, test::cases(1000),
                             [&] { return test::random_ray(random); });
  }
  EXPECT_GT(hits, test::cases(2000));
}

/// A mesh that is hard on a builder, and where its rays are.
struct HardMesh {
  std::string name;
  Mesh mesh;
  Vec3 middle{0.0f};
  float reach = 12.0f;
  int least_hits = 0;  ///< of 2000 rays
};

Mesh scaled(Mesh mesh, float scale, const Vec3& offset = Vec3(0.0f)) {
  for (Vec3& p : mesh.positions) p = p * scale + offset;
  return mesh;
}

/// Triangles that shrink towards the origin by a half each: no plane parts them evenly. The
/// smallest ones are still much larger than the roundings of a ray that comes from some metres
/// away.
Mesh shrinking_triangles() {
  Mesh mesh;
  for (int i = -35; i < 100; ++i) {
    const float size = std::ldexp(1.0f, i);
    add_triangle(mesh, {size, 0, 0}, {0, size, 0}, {0, 0, size});
  }
  return mesh;
}

/// Points and lines, in general places and on the axes, and one real triangle.
Mesh flat_triangles(Random& random) {
  Mesh mesh;
  for (int i = 0; i < 50; ++i) {
    const Vec3 a = glm::round(random.cube(4.0f));
    const Vec3 b = random.cube(4.0f);
    add_triangle(mesh, a, a, a);
    add_triangle(mesh, a, b, a);
    add_triangle(mesh, a, a + Vec3(1, 0, 0), a + Vec3(3, 0, 0));
  }
  add_triangle(mesh, {-5, -5, 0}, {5, -5, 0}, {0, 5, 0});
  return mesh;
}

std::vector<HardMesh> hard_meshes(Random& random) {
  const Mesh soup = test::triangle_soup(random, 200, 4.0f, 2.0f);
  Mesh same_place;
  Mesh same_middle;
  for (int i = 0; i < 300; ++i) {
    add_triangle(same_place, {-3, -3, 0}, {3, -3, 0}, {0, 3, 1});
    const Vec3 arm = random.cube(5.0f);
    add_triangle(same_middle, -arm, arm, Vec3(arm.x, -arm.y, arm.z));
  }
  Mesh one;
  add_triangle(one, {-3, -3, 0}, {3, -3, 0}, {0, 3, 1});
  return {
      {"nothing", Mesh{}},
      {"one triangle", one, Vec3(0.0f), 12.0f, 50},
      {"all in one place", same_place, Vec3(0.0f), 12.0f, 50},
      {"around one point", same_middle, Vec3(0.0f), 12.0f, 500},
      {"without area", flat_triangles(random), Vec3(0.0f), 6.0f, 50},
      {"shrinking", shrinking_triangles(), Vec3(0.0f), 1.0f, 500},
      {"immense", scaled(soup, 1e30f), Vec3(0.0f), 1e17f, 500},
      {"as large as can be", scaled(soup, 5e37f), Vec3(0.0f), 1e17f, 500},
      {"far away", scaled(soup, 1.0f, {1e6f, -1e6f, 1e6f}), {1e6f, -1e6f, 1e6f}, 12.0f, 500},
      {"tiny", scaled(soup, 1e-20f), Vec3(0.0f), 12e-20f, 500},
      {"tiny in the distance", scaled(soup, 1e-3f, {100, 1, 10}), {100, 1, 10}, 12e-3f, 500},
  };
}

TEST(Bvh, HardMeshes_MeetWhatBruteForceMeets) {
  Random random(4);
  for (const HardMesh& hard : hard_meshes(random)) {
    World world;
    test::add_instance(world, hard.mesh);
    const auto random_ray = [&] {
      Ray ray{.origin = hard.middle + random.cube(hard.reach)};
      ray.direction = hard.middle + random.cube(0.7f * hard.reach) - ray.origin;
      return ray;
    };
    const auto axis_ray = [&] {
      Ray ray = test::axis_ray(random);
      ray.origin += hard.middle;
      return ray;
    };
    const int hits = expect_all_agree(world, nullptr, test::cases(2000), random_ray);
    EXPECT_GE(hits, test::cases(hard.least_hits)) << hard.name;
    expect_all_agree(world, nullptr, test::cases(1000), axis_ray);
    if (HasFailure()) FAIL() << hard.name;
  }
}

TEST(Bvh, WorldsWithoutTriangles_MeetTheirShapesOrNothing) {
  World world;
  for (const std::string_view name : k_names) {
    EXPECT_FALSE(make_accelerator(name, world, nullptr)->closest_hit({})) << name;
  }
  test::add_instance(world, Sphere{1.0});
  for (const std::string_view name : k_names) {
    const auto accelerator = make_accelerator(name, world, nullptr);
    EXPECT_EQ(accelerator->closest_hit({.origin = {0, 0, 3}}), Hit{}) << name;
    EXPECT_FALSE(accelerator->any_hit({.origin = {0, 2, 3}})) << name;
  }
}

TEST(Bvh, Counting_SaysHowLittleIsLookedAt) {
  World world;
  test::add_instance(world, test::sphere_mesh(40));  // 6,240 triangles
  const Ray ray{.origin = {0.1f, 0.2f, 3.0f}};
  for (const std::string_view name : k_names) {
    const auto accelerator = make_accelerator(name, world, nullptr);
    TraversalCost cost;
    EXPECT_EQ(accelerator->closest_hit_counted(ray, cost), accelerator->closest_hit(ray)) << name;
    // Some 12 levels down to the triangle, on both sides of an edge now and then.
    EXPECT_GE(cost.nodes, 8u) << name;
    EXPECT_LE(cost.nodes, 200u) << name;
    EXPECT_LE(cost.primitive_tests, 60u) << name;
    EXPECT_GE(cost.primitive_tests, 1u) << name;
  }
}

TEST(Bvh, Stats_SayWhatATreeIsMadeOf) {
  World world;
  test::add_instance(world, test::sphere_mesh(32));  // 3,968 triangles
  for (const std::string_view name : k_names) {
    const StructureStats stats = make_accelerator(name, world, nullptr)->stats().structure;
    // Two trees, that of the triangles and that of the instance, which is one leaf.
    EXPECT_EQ(stats.leaves, stats.nodes + 2) << name;
    EXPECT_GE(stats.depth, 9u) << name;
    EXPECT_LE(stats.depth, 30u) << name;
    EXPECT_GE(stats.references, 3969u) << name;
    EXPECT_LE(stats.references, 3968u * 5 / 4 + 1) << name;
    EXPECT_GT(stats.sah_cost, 5.0) << name;
    EXPECT_LT(stats.sah_cost, 100.0) << name;
    EXPECT_GT(stats.memory_bytes, 32 * (stats.nodes + stats.leaves)) << name;
  }
}

}  // namespace
}  // namespace lume::geometry
