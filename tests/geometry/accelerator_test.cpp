// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/accelerator.h"

#include "geometry/parallel.h"
#include "geometry/refine.h"
#include "geometry/surface_point.h"
#include "tests/support/random.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lume::geometry {
namespace {

using test::Random;

/// Several objects with two geometries each, instanced under random transforms.
World random_world(Random& random) {
  World world;
  for (int object = 0; object < 4; ++object) {
    world.objects.push_back({"",
                             {{test::triangle_soup(random, 20, 1.0f, 0.5f)},
                              {test::triangle_soup(random, 30, 1.0f, 0.5f)}}});
  }
  for (std::uint32_t i = 0; i < 12; ++i) {
    world.instances.push_back({"", i % 4, Transform(test::random_transform(random, 5.0f))});
  }
  return world;
}

Ray random_ray(Random& random) {
  Ray ray{.origin = random.cube(12.0f), .direction = random.cube(8.0f)};
  ray.direction -= ray.origin;
  if (random.uniform() < 0.3f) ray.t_max = random.uniform(0.2f, 1.5f);
  return ray;
}

/// Whether a float's rounding can decide if the ray meets the primitive: it passes an edge, or its
/// own end, more closely than that.
bool is_marginal(const World& world, const Ray& ray, const std::optional<Hit>& hit) {
  if (!hit) return false;
  constexpr double k_margin = 1e-5;
  const Crossing crossing = refine(world, ray, *hit, nullptr);
  const double w = 1.0 - crossing.u - crossing.v;
  return std::min({crossing.u, crossing.v, w}) < k_margin ||
         std::abs(crossing.t - static_cast<double>(ray.t_max)) < k_margin;
}

/// Traces random rays through random worlds with Embree and the oracle. Where they disagree,
/// rounding must be to blame, and that seldom. Returns the number of hits.
int compare_with_brute_force(Random& random, const World& world, const HoleTest* holes) {
  constexpr int k_rays = 500;
  const auto embree = make_accelerator("embree", world, holes);
  const auto oracle = make_accelerator("brute-force", world, holes);
  int hits = 0;
  int disagreements = 0;
  for (int i = 0; i < k_rays; ++i) {
    const Ray ray = random_ray(random);
    const auto hit = embree->closest_hit(ray);
    const auto expected = oracle->closest_hit(ray);
    const bool occluded = embree->any_hit(ray);
    if (hit) ++hits;
    if (hit == expected && occluded == expected.has_value()) continue;
    ++disagreements;
    const bool same_place = hit && expected &&
                            std::abs(refine(world, ray, *hit, nullptr).t -
                                     refine(world, ray, *expected, nullptr).t) < 1e-5;
    EXPECT_TRUE(same_place || is_marginal(world, ray, hit) || is_marginal(world, ray, expected))
        << "ray " << i;
  }
  EXPECT_LE(disagreements, 2);
  return hits;
}

TEST(Embree, RandomWorlds_MeetWhatBruteForceMeets) {
  Random random(1);
  int hits = 0;
  for (int round = 0; round < 20; ++round) {
    hits += compare_with_brute_force(random, random_world(random), nullptr);
  }
  EXPECT_GT(hits, 2000);
}

/// A hole wherever the first barycentric coordinate is below a half.
class HalfTriangles final : public HoleTest {
 public:
  bool is_hole(const Hit&, Vec2 uv) const override { return uv.x < 0.5f; }
};

TEST(Embree, Holes_LetEveryKindOfRayThrough) {
  Random random(2);
  const HalfTriangles holes;
  int hits = 0;
  for (int round = 0; round < 10; ++round) {
    World world = random_world(random);
    for (Object& object : world.objects) object.geometries[0].has_holes = true;
    hits += compare_with_brute_force(random, world, &holes);
  }
  EXPECT_GT(hits, 1000);

  // A hole is open to both kinds of ray, and only where the mesh admits to having any.
  World world;
  test::add_instance(world, test::square_mesh());
  const Ray through_hole{.origin = {-0.4f, 0.3f, 1.0f}};  // u is 0.1 there
  for (const bool has_holes : {false, true}) {
    world.objects[0].geometries[0].has_holes = has_holes;
    for (const std::string_view name : accelerator_names()) {
      const auto accelerator = make_accelerator(name, world, &holes);
      EXPECT_EQ(accelerator->any_hit(through_hole), !has_holes) << name;
      EXPECT_EQ(accelerator->closest_hit(through_hole).has_value(), !has_holes) << name;
    }
  }
}

TEST(Accelerators, RaysThatAreNotFinite_MeetNothing) {
  World world;
  test::add_instance(world, test::square_mesh());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<Ray> rays = {{.origin = {nan, 0, 0}},
                                 {.origin = {inf, 0, 0}},
                                 {.direction = {0, nan, 0}},
                                 {.direction = {0, 0, inf}},
                                 {.origin = {0, 3e18f, 0}},
                                 {.t_min = -1.0f},
                                 {.t_max = nan},
                                 {.t_min = nan},
                                 {.t_min = 2.0f, .t_max = 1.0f}};
  for (const std::string_view name : accelerator_names()) {
    const auto accelerator = make_accelerator(name, world, nullptr);
    for (const Ray& ray : rays) {
      EXPECT_FALSE(accelerator->closest_hit(ray)) << name;
      EXPECT_FALSE(accelerator->any_hit(ray)) << name;
    }
  }
}

TEST(Accelerators, EmptyWorldsAndMeshes_MeetNothing) {
  World empty;
  World hollow;
  hollow.objects.push_back({"", {{Mesh{}}}});
  hollow.objects.push_back({"", {}});
  hollow.instances.resize(2);
  hollow.instances[1].object = 1;
  for (const std::string_view name : accelerator_names()) {
    EXPECT_FALSE(make_accelerator(name, empty, nullptr)->closest_hit({}));
    EXPECT_FALSE(make_accelerator(name, hollow, nullptr)->closest_hit({}));
    EXPECT_FALSE(make_accelerator(name, hollow, nullptr)->any_hit({}));
  }
}

TEST(Accelerators, UnknownName_Throws) {
  EXPECT_THROW((void)make_accelerator("embre", World{}, nullptr), std::invalid_argument);
}

TEST(Accelerators, Stats_CountPrimitivesOnceAndInstances) {
  World world;
  test::add_instance(world, test::square_mesh());
  world.instances.push_back(world.instances[0]);
  for (const std::string_view name : accelerator_names()) {
    const AcceleratorStats stats = make_accelerator(name, world, nullptr)->stats();
    EXPECT_EQ(stats.primitives, 2u);
    EXPECT_EQ(stats.instances, 2u);
  }
  EXPECT_GT(make_accelerator("embree", world, nullptr)->stats().memory_bytes, 0u);
}

TEST(Embree, CoplanarTwins_AreTheSameHitForAnyNumberOfThreads) {
  // Every triangle twice in the same place: who wins is decided by the order in Embree's leaves.
  Random random(3);
  World world;
  Mesh twins = test::triangle_soup(random, 50000, 10.0f, 0.2f);
  const std::vector<UVec3> once = twins.triangles;
  twins.triangles.insert(twins.triangles.end(), once.begin(), once.end());
  test::add_instance(world, twins);
  std::vector<Ray> rays;
  rays.reserve(3000);
  for (int i = 0; i < 3000; ++i) rays.push_back(random_ray(random));

  std::vector<std::vector<std::optional<Hit>>> hits;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    const auto embree = make_accelerator("embree", world, nullptr);
    hits.emplace_back();
    for (const Ray& ray : rays) hits.back().push_back(embree->closest_hit(ray));
  }
  EXPECT_EQ(hits[0], hits[1]);
  EXPECT_EQ(hits[0], hits[2]);
}

/// Rays from everywhere inside a closed mesh, aimed at its edges and corners.
TEST(Embree, ClosedMesh_LeaksLessThanOneRayInThousand) {
  Random random(4);
  World world;
  test::add_instance(world, test::sphere_mesh(24), test::random_transform(random));
  const auto embree = make_accelerator("embree", world, nullptr);
  const Mesh& mesh = test::mesh_of(world);
  const Transform& transform = world.instances[0].transform;
  int leaks = 0;
  constexpr int k_rays = 20000;
  for (int i = 0; i < k_rays; ++i) {
    const UVec3 corners =
        mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const float along = random.uniform();
    const Vec3 aim = mesh.positions[corners.x] * (1.0f - along) + mesh.positions[corners.y] * along;
    const Vec3 origin(transform.point_to_world(DVec3(random.cube(0.4f))));
    const Vec3 target(transform.point_to_world(DVec3(aim)));
    if (!embree->any_hit({.origin = origin, .direction = target - origin})) ++leaks;
  }
  EXPECT_LT(leaks, k_rays / 1000);
}

}  // namespace
}  // namespace lume::geometry
