// SPDX-License-Identifier: Apache-2.0
// The ray sets are what they say they are.
#include "renderer/bench/ray_sets.h"

#include "renderer/bench/hit_rate.h"
#include "renderer/bench/measure.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>

namespace lume::renderer {
namespace {

using geometry::Ray;

constexpr std::array k_all = {RaySetKind::primary, RaySetKind::shadow, RaySetKind::diffuse,
                              RaySetKind::bounce2, RaySetKind::ao};

/// A sphere on a floor at y = -1, and a lamp above.
shading::Scene sphere_scene() {
  shading::Scene scene;
  test::add_surface(scene, test::sphere_mesh(12));
  geometry::DMat4 floor(1.0);
  floor[1] = {0.0, 0.0, -1.0, 0.0};  // the square's normal, +z, becomes +y
  floor[2] = {0.0, 1.0, 0.0, 0.0};
  floor[3] = {0.0, -1.0, 0.0, 1.0};
  test::add_surface(scene, test::square_mesh(6.0f), floor);
  shading::PunctualLight lamp;
  lamp.position = {0.0f, 5.0f, 1.0f};
  scene.lights.push_back(lamp);
  return scene;
}

class RaySets : public testing::Test {
 protected:
  RaySets() : scene_(sphere_scene()), prepared_(scene_, "brute-force") {}

  [[nodiscard]] RaySet record(RaySetKind kind) const {
    return record_rays(prepared_, camera_, settings_, {&kind, 1})[0];
  }
  /// The point of a surface that the ray starts from: the nearest.
  [[nodiscard]] float distance_to_surface(const Vec3& p) const {
    const float to_sphere = std::abs(length(p) - 1.0f);  // the mesh is within 0.02 of the sphere
    return std::min(to_sphere, std::abs(p.y + 1.0f));
  }

  shading::Scene scene_;
  PreparedScene prepared_;
  geometry::Camera camera_ = geometry::look_at({0.0f, 0.5f, 4.0f}, Vec3(0.0f), 0.9f);
  RaySetSettings settings_{1000, 64, 48, 5, 0.5f};
};

TEST_F(RaySets, Sets_HaveTheirCountAndNames) {
  const std::vector<RaySet> sets = record_rays(prepared_, camera_, settings_, k_all);
  ASSERT_EQ(sets.size(), ray_set_infos().size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    EXPECT_EQ(sets[i].name, ray_set_infos()[i].name);
    EXPECT_EQ(sets[i].any_hit, ray_set_infos()[i].any_hit);
    EXPECT_EQ(sets[i].rays.size(), settings_.count) << sets[i].name;
    for (const Ray& ray : sets[i].rays) EXPECT_TRUE(is_traceable(ray));
  }
}

TEST_F(RaySets, Recording_IsTheSameForEveryStructureAndAlone) {
  const PreparedScene other(scene_, "embree");
  const auto a = record_rays(prepared_, camera_, settings_, k_all);
  const auto b = record_rays(other, camera_, settings_, k_all);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const RaySet alone = record(k_all[i]);
    const std::size_t bytes = a[i].rays.size() * sizeof(Ray);
    EXPECT_EQ(std::memcmp(a[i].rays.data(), b[i].rays.data(), bytes), 0) << a[i].name;
    EXPECT_EQ(std::memcmp(a[i].rays.data(), alone.rays.data(), bytes), 0) << a[i].name;
  }
  settings_.seed = 6;
  EXPECT_NE(std::memcmp(a[2].rays.data(), record(RaySetKind::diffuse).rays.data(), 1000), 0);
}

/// Where on the image plane the ray goes through, in pixels.
Vec2 pixel_of(const Ray& ray, const geometry::Camera& camera, const RaySetSettings& settings) {
  const float depth = -dot(ray.direction, camera.backward);
  const float half = std::tan(0.5f * camera.vertical_fov);
  const auto height = static_cast<float>(settings.height);
  const auto width = static_cast<float>(settings.width);
  const float x = dot(ray.direction, camera.right) / depth / half;
  const float y = dot(ray.direction, camera.up) / depth / half;
  return {0.5f * (width + x * height), 0.5f * (height - y * height)};
}

TEST_F(RaySets, Primary_RunsOfSixteenAreBlocksOfPixels) {
  settings_.count = 16 * 50;
  const RaySet set = record(RaySetKind::primary);
  std::set<std::pair<int, int>> blocks;
  for (std::size_t i = 0; i < set.rays.size(); i += 16) {
    const Vec2 first = glm::floor(pixel_of(set.rays[i], camera_, settings_) / 4.0f);
    blocks.insert({static_cast<int>(first.x), static_cast<int>(first.y)});
    std::set<std::pair<int, int>> pixels;
    for (std::size_t k = 0; k < 16; ++k) {
      const Vec2 pixel = pixel_of(set.rays[i + k], camera_, settings_);
      EXPECT_EQ(set.rays[i + k].origin, camera_.position);
      EXPECT_EQ(glm::floor(pixel / 4.0f), first);
      pixels.insert({static_cast<int>(pixel.x), static_cast<int>(pixel.y)});
    }
    EXPECT_GE(pixels.size(), 14u);  // a sample on a pixel's border may round into the next
  }
  EXPECT_EQ(blocks.size(), 50u);  // of the 192 that there are, none twice
}

TEST_F(RaySets, Primary_MoreRaysThanPixels_CoverAllEvenly) {
  settings_.count = 64 * 48 * 2;
  std::vector<int> samples(64 * 48);
  for (const Ray& ray : record(RaySetKind::primary).rays) {
    const Vec2 pixel = pixel_of(ray, camera_, settings_);
    ++samples[static_cast<std::size_t>(pixel.y) * 64 + static_cast<std::size_t>(pixel.x)];
  }
  EXPECT_EQ(std::accumulate(samples.begin(), samples.end(), 0), 64 * 48 * 2);
  EXPECT_GE(std::count(samples.begin(), samples.end(), 2), 64 * 48 * 9 / 10);
}

TEST_F(RaySets, Shadow_RaysGoFromSurfacesToTheLamp) {
  for (const Ray& ray : record(RaySetKind::shadow).rays) {
    EXPECT_LT(distance_to_surface(ray.origin), 0.02f);
    EXPECT_LT(distance(ray.origin + ray.direction, scene_.lights[0].position), 1e-4f);
    EXPECT_LT(ray.t_max, 1.0f);
  }
}

TEST_F(RaySets, Shadow_WithoutLightsGoesUp) {
  scene_.lights.clear();
  const PreparedScene dark(scene_, "brute-force");
  const RaySetKind kind = RaySetKind::shadow;
  const RaySet set = record_rays(dark, camera_, settings_, {&kind, 1})[0];
  EXPECT_EQ(set.rays.size(), settings_.count);
  for (const Ray& ray : set.rays) EXPECT_GT(ray.direction.y, 0.3f);
}

TEST_F(RaySets, Diffuse_FollowsTheCosineLaw) {
  settings_.count = 20000;
  double sum = 0.0;
  int count = 0;
  for (const Ray& ray : record(RaySetKind::diffuse).rays) {
    EXPECT_LT(distance_to_surface(ray.origin), 0.02f);
    if (std::abs(ray.origin.y + 1.0f) > 1e-3f) continue;
    EXPECT_GT(ray.direction.y, 0.0f);
    sum += ray.direction.y;
    ++count;
  }
  ASSERT_GT(count, 2000);
  // The mean cosine of the density cos / pi is 2/3, its variance 1/2 - 4/9 = 1/18.
  EXPECT_NEAR(sum / count, 2.0 / 3.0, 5.0 * std::sqrt(1.0 / 18.0 / count));
}

TEST_F(RaySets, Bounce2_StartsWhereDiffuseRaysEnd) {
  for (const Ray& ray : record(RaySetKind::bounce2).rays) {
    EXPECT_LT(distance_to_surface(ray.origin), 0.02f);
  }
}

TEST_F(RaySets, Ao_IsShortAndShuffled) {
  const RaySet ao = record(RaySetKind::ao);
  const auto steps = [](const RaySet& set) {
    double sum = 0.0;
    for (std::size_t i = 1; i < set.rays.size(); ++i) {
      sum += distance(set.rays[i].origin, set.rays[i - 1].origin);
    }
    return sum;
  };
  for (const Ray& ray : ao.rays) EXPECT_EQ(ray.t_max, 0.5f);
  EXPECT_GT(steps(ao), 2.0 * steps(record(RaySetKind::diffuse)));
}

TEST_F(RaySets, NothingInSight_LeavesOnlyPrimaryRays) {
  camera_ = geometry::look_at({0.0f, 0.5f, 40.0f}, {0.0f, 0.5f, 80.0f}, 0.5f);
  const auto sets = record_rays(prepared_, camera_, settings_, k_all);
  EXPECT_EQ(sets[0].rays.size(), settings_.count);
  for (std::size_t i = 1; i < sets.size(); ++i) EXPECT_TRUE(sets[i].rays.empty());
}

TEST_F(RaySets, HitRate_IsKept) {
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    RaySet set = record(RaySetKind::primary);
    const HitCounts recorded = keep_hit_rate(set, prepared_.accelerator(), share);
    EXPECT_EQ(recorded.total(), settings_.count);
    ASSERT_FALSE(set.rays.empty());
    const auto hits = std::count_if(set.rays.begin(), set.rays.end(), [&](const Ray& ray) {
      return prepared_.accelerator().any_hit(ray);
    });
    EXPECT_NEAR(static_cast<double>(hits), share * static_cast<double>(set.rays.size()), 1.0);
  }
}

TEST(SpreadRays, TakesWholeRunsFromBeginningToEnd) {
  std::vector<Ray> rays(16 * 100);
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i].t_min = static_cast<float>(i);
  const std::vector<Ray> part = spread_rays(rays, 16 * 10);
  ASSERT_EQ(part.size(), 160u);
  for (std::size_t i = 0; i < part.size(); ++i) {
    EXPECT_EQ(part[i].t_min, static_cast<float>(i / 16 * 160 + i % 16));
  }
  EXPECT_EQ(spread_rays(rays, 5000).size(), rays.size());
  EXPECT_EQ(spread_rays({rays.data(), 10}, 5).size(), 5u);
}

}  // namespace
}  // namespace lume::renderer
