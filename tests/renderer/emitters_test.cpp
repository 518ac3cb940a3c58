// SPDX-License-Identifier: Apache-2.0
#include "renderer/emitters.h"

#include "tests/support/chi_squared.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace lume::renderer {
namespace {

using shading::Color;
using shading::Scene;
using test::Random;

double world_area(const Scene& scene, const geometry::Hit& hit) {
  const auto [a, b, c] = scene.world.geometry(hit).mesh()->corners(hit.primitive);
  const auto& transform = scene.world.instances[hit.instance].transform;
  return 0.5 * length(cross(transform.vector_to_world(geometry::DVec3(b - a)),
                            transform.vector_to_world(geometry::DVec3(c - a))));
}

/// d^2 / cos: a density per m^2 times this is one per steradian.
double steradian_to_area(const EmitterSample& sample, const Vec3& from) {
  const geometry::DVec3 offset = geometry::DVec3(sample.position) - geometry::DVec3(from);
  const double distance = length(offset);
  return distance * distance * distance / std::abs(dot(offset, geometry::DVec3(sample.normal)));
}

geometry::SurfacePoint met_at(const EmitterSample& sample) {
  geometry::SurfacePoint met;
  met.hit = sample.hit;
  met.position = sample.position;
  met.geometric_normal = sample.normal;
  return met;
}

/// Two emissive soups with instances, and a dark one between them.
Scene random_emitters(Random& random) {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    auto& material = test::add_surface(scene, test::triangle_soup(random, 20, 1.0f, 0.6f),
                                       test::random_transform(random));
    material.emission = i == 1 ? Color(0.0f) : Color(1.0f + static_cast<float>(i));
  }
  scene.world.instances.push_back({"", 0, geometry::Transform(test::random_transform(random))});
  return scene;
}

TEST(Emitters, Samples_FollowAreaTimesLuminance) {
  Random random(1);
  const Scene scene = random_emitters(random);
  const Emitters emitters(scene);
  ASSERT_EQ(emitters.size(), 60u);
  constexpr int k_samples = 100000;
  std::map<geometry::Hit, double> counts;
  double total = 0.0;
  for (std::uint32_t instance = 0; instance < 4; ++instance) {
    if (instance == 1) continue;
    for (std::uint32_t i = 0; i < 20; ++i) {
      const geometry::Hit hit{instance, 0, i};
      counts[hit] = 0.0;
      total += world_area(scene, hit) * (instance == 2 ? 3.0 : 1.0);
    }
  }
  for (int i = 0; i < k_samples; ++i) {
    const Vec3 from = random.cube(20.0f);
    const EmitterSample sample = emitters.sample(random.uniform(), random.square(), from);
    ASSERT_EQ(counts.count(sample.hit), 1u) << "a dark triangle";
    counts[sample.hit] += 1.0;
    const double per_m2 = (sample.hit.instance == 2 ? 3.0 : 1.0) / total;  // area cancels
    const double expected = per_m2 * steradian_to_area(sample, from);
    ASSERT_NEAR(sample.pdf, expected, 1e-3 * expected);
    ASSERT_EQ(emitters.pdf(met_at(sample), from), sample.pdf);
  }
  std::vector<double> observed;
  std::vector<double> expected;
  for (const auto& [hit, count] : counts) {
    observed.push_back(count);
    expected.push_back(k_samples * world_area(scene, hit) * (hit.instance == 2 ? 3.0 : 1.0) /
                       total);
  }
  test::expect_chi_squared(observed, expected);
  EmitterSample dark;
  dark.hit = {1, 0, 3};
  dark.normal = {0, 0, 1};
  EXPECT_EQ(emitters.pdf(met_at(dark), {1, 2, 3}), 0.0f);
}

TEST(Emitters, PointsOnATriangle_AreUniform) {
  Scene scene;
  geometry::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 2, 1}};
  mesh.triangles = {{0, 1, 2}};
  test::add_surface(scene, mesh).emission = Color(1.0f);
  const Emitters emitters(scene);
  Random random(2);
  constexpr int k_grid = 8;
  constexpr int k_samples = 50000;
  std::vector<double> counts(k_grid * k_grid, 0.0);
  for (int i = 0; i < k_samples; ++i) {
    const EmitterSample s = emitters.sample(random.uniform(), random.square(), {5, -3, 9});
    const Vec3 expected = s.uv.x * mesh.positions[1] + s.uv.y * mesh.positions[2];
    ASSERT_LT(length(s.position - expected), 1e-5f);
    ASSERT_NEAR(dot(s.normal, glm::normalize(Vec3(0, -1, 2))), 1.0f, 1e-5f);
    const auto x = static_cast<std::size_t>(s.uv.x * k_grid);
    const auto y = static_cast<std::size_t>(s.uv.y * k_grid);
    counts[x * k_grid + y] += 1.0;
  }
  std::vector<double> expected(counts.size(), 0.0);
  for (std::size_t x = 0; x < k_grid; ++x) {
    for (std::size_t y = 0; x + y < k_grid; ++y) {
      const bool on_diagonal = x + y == k_grid - 1;
      expected[x * k_grid + y] = k_samples * (on_diagonal ? 0.5 : 1.0) * 2.0 / (k_grid * k_grid);
    }
  }
  test::expect_chi_squared(counts, expected);
}

/// A square of 4 m^2 as two triangles and as a rectangle, a sphere of pi m^2 that is twice as
/// bright, and shapes there is no aiming at.
Scene mixed_emitters() {
  Scene scene;
  test::add_surface(scene, test::square_mesh(1.0f)).emission = Color(1.0f);
  test::add_surface(scene, geometry::Plane{}).emission = Color(9.0f);
  test::add_surface(scene, geometry::Plane{2.0, 2.0}).emission = Color(1.0f);
  test::add_surface(scene, geometry::Torus{}).emission = Color(9.0f);
  test::add_surface(scene, geometry::Sphere{0.5}, test::translation(0, 5, 0)).emission =
      Color(2.0f);
  test::add_surface(scene, geometry::Box{});
  return scene;
}

TEST(Emitters, ShapesBesideTriangles_GetTheirShare) {
  const Scene scene = mixed_emitters();
  const Emitters emitters(scene);
  ASSERT_EQ(emitters.size(), 4u);
  const double total = 8.0 + 2.0 * M_PI;
  std::map<std::uint32_t, double> shares;
  Random random(4);
  constexpr int k_samples = 100000;
  for (int i = 0; i < k_samples; ++i) {
    const EmitterSample s = emitters.sample(random.uniform(), random.square(), {3, 2, 4});
    ASSERT_EQ(emitters.pdf(met_at(s), {3, 2, 4}), s.pdf);
    shares[s.hit.instance] += 1.0 / k_samples;
  }
  EXPECT_EQ(shares.size(), 3u);
  EXPECT_NEAR(shares[0], 4.0 / total, 5e-3);
  EXPECT_NEAR(shares[2], 4.0 / total, 5e-3);
  EXPECT_NEAR(shares[4], 2.0 * M_PI / total, 5e-3);
  // The two triangles and the rectangle are as likely per m^2.
  geometry::SurfacePoint met;
  met.geometric_normal = {0, 0, 1};
  met.hit = {0, 0, 1};
  const float by_triangle = emitters.pdf(met, {0, 0, 2});
  met.hit = {2, 0, 0};
  EXPECT_NEAR(emitters.pdf(met, {0, 0, 2}), by_triangle, 1e-6f);
  EXPECT_NEAR(by_triangle, 4.0 / total, 1e-5);
}

TEST(Emitters, ShapesWithoutAim_AreListedAndLightNothing) {
  const Scene scene = mixed_emitters();
  const std::vector<geometry::Hit> expected = {{1, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(unsampled_emitters(scene), expected);
  geometry::SurfacePoint met;
  met.geometric_normal = {0, 1, 0};
  for (const geometry::Hit& hit : expected) {
    met.hit = hit;
    EXPECT_EQ(Emitters(scene).pdf(met, {0, 2, 0}), 0.0f);
  }
  EXPECT_TRUE(unsampled_emitters(Scene{}).empty());
}

/// Half of every shape is dark: the lower half of its image.
TEST(Emitters, TexturedShapes_CountTheirMeanLuminance) {
  Scene scene;
  scene.textures.emplace_back().checker.emplace();
  scene.textures[0].checker->checks = {1.0f, 2.0f};
  for (const bool textured : {false, true}) {
    for (const geometry::Shape& shape :
         {geometry::Shape(geometry::Sphere{1.0}), geometry::Shape(geometry::Plane{1.0, 1.0}),
          geometry::Shape(geometry::Disk{1.0, 0.0})}) {
      shading::Material& material = test::add_surface(scene, shape);
      material.emission = Color(1.0f);
      if (textured) material.emission_texture.texture = 0;
    }
  }
  const Emitters emitters(scene);
  Random random(5);
  std::array<double, 6> counts{};
  for (int i = 0; i < 100000; ++i) {
    counts[emitters.sample(random.uniform(), random.square(), {9, 9, 9}).hit.instance] += 1.0;
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(counts[i + 3] / counts[i], 0.5, 0.04) << i;
}

TEST(Emitters, SameNumbers_GiveTheSameSample) {
  const Scene scene = mixed_emitters();
  const Emitters first(scene);
  const Emitters second(scene);
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const float choice = random.uniform();
    const Vec2 place = random.square();
    const Vec3 from = random.cube(5.0f);
    const EmitterSample a = first.sample(choice, place, from);
    const EmitterSample b = second.sample(choice, place, from);
    ASSERT_EQ(a.hit, b.hit);
    ASSERT_EQ(a.position, b.position);
    ASSERT_EQ(a.pdf, b.pdf);
  }
}

TEST(Emitters, DarkScene_IsEmpty) {
  Scene scene;
  test::add_surface(scene, test::square_mesh());
  EXPECT_TRUE(Emitters(scene).empty());
  EXPECT_EQ(Emitters(scene).pdf(geometry::SurfacePoint{}, {0, 0, 1}), 0.0f);
  // Unlit materials show their colour but light nothing.
  scene.materials[0].emission = Color(1.0f);
  scene.materials[0].unlit = true;
  EXPECT_TRUE(Emitters(scene).empty());
}

}  // namespace
}  // namespace lume::renderer
