// SPDX-License-Identifier: Apache-2.0
#include "renderer/emitters.h"

#include "tests/support/chi_squared.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <map>

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
    const EmitterSample sample = emitters.sample(random.uniform(), random.square());
    ASSERT_EQ(counts.count(sample.hit), 1u) << "a dark triangle";
    counts[sample.hit] += 1.0;
    const double expected =
        (sample.hit.instance == 2 ? 3.0 : 1.0) / total;  // per m^2, area cancels
    ASSERT_NEAR(sample.area_pdf, expected, 1e-3 * expected);
    ASSERT_NEAR(emitters.area_pdf(sample.hit), sample.area_pdf, 1e-6f * sample.area_pdf);
  }
  std::vector<double> observed;
  std::vector<double> expected;
  for (const auto& [hit, count] : counts) {
    observed.push_back(count);
    expected.push_back(k_samples * world_area(scene, hit) * (hit.instance == 2 ? 3.0 : 1.0) /
                       total);
  }
  test::expect_chi_squared(observed, expected);
  EXPECT_EQ(emitters.area_pdf({1, 0, 3}), 0.0f);
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
    const EmitterSample s = emitters.sample(random.uniform(), random.square());
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

TEST(Emitters, DarkScene_IsEmpty) {
  Scene scene;
  test::add_surface(scene, test::square_mesh());
  EXPECT_TRUE(Emitters(scene).empty());
  EXPECT_EQ(Emitters(scene).area_pdf({0, 0, 0}), 0.0f);
  // Unlit materials show their colour but light nothing.
  scene.materials[0].emission = Color(1.0f);
  scene.materials[0].unlit = true;
  EXPECT_TRUE(Emitters(scene).empty());
}

}  // namespace
}  // namespace lume::renderer
