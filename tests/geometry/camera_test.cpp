// SPDX-License-Identifier: Apache-2.0
#include "geometry/camera.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

using test::Random;

void expect_near(const Vec3& a, const Vec3& b, float tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Where a point appears in the image: x to the right and y down, both 0..1.
Vec2 project(const Camera& camera, const Vec3& point, float aspect) {
  const Vec3 to_point = point - camera.position;
  const float depth = -dot(to_point, camera.backward);
  const float half = std::tan(0.5f * camera.vertical_fov) * depth;
  return {0.5f + 0.5f * dot(to_point, camera.right) / (half * aspect),
          0.5f - 0.5f * dot(to_point, camera.up) / half};
}

TEST(Camera, PerspectiveRay_GoesThroughTheProjectedPoint) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 target = random.cube(3.0f);
    const Camera camera =
        look_at(target + 5.0f * random.direction(), target, random.uniform(0.2f, 2.0f));
    const Vec3 point = target + random.cube(0.5f);
    const Ray ray = camera.generate_ray(project(camera, point, 1.5f), 1.5f);
    EXPECT_NEAR(length(ray.direction), 1.0f, 1e-5f);
    const Vec3 to_point = point - ray.origin;
    ASSERT_LT(length(cross(ray.direction, normalize(to_point))), 2e-5f);
    ASSERT_GT(dot(ray.direction, to_point), 0.0f);
  }
}

TEST(Camera, Corners_SpanTheFieldOfView) {
  Camera camera;
  camera.vertical_fov = k_pi / 2.0f;
  expect_near(camera.generate_ray({0.5f, 0.5f}, 2.0f).direction, {0, 0, -1}, 1e-6f);
  expect_near(camera.generate_ray({0.5f, 0.0f}, 2.0f).direction, normalize(Vec3(0, 1, -1)), 1e-6f);
  expect_near(camera.generate_ray({1.0f, 0.5f}, 2.0f).direction, normalize(Vec3(2, 0, -1)), 1e-6f);
}

TEST(Camera, Orthographic_RaysAreParallel) {
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  camera.half_height = 3.0f;
  const Ray top_left = camera.generate_ray({0.0f, 0.0f}, 2.0f);
  expect_near(top_left.origin, {-6, 3, 0}, 1e-5f);
  expect_near(top_left.direction, {0, 0, -1}, 0.0f);
}

TEST(Orbit, DocumentedFormula_PlacesTheEye) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 target = random.cube(5.0f);
    const float theta = random.uniform(-3.0f, 3.0f);
    const float phi = random.uniform(0.1f, 3.0f);
    const Camera camera = orbit(target, theta, phi, 4.0f, 0.7f);
    const Vec3 eye = target + 4.0f * Vec3(std::sin(phi) * std::sin(theta), std::cos(phi),
                                          std::sin(phi) * std::cos(theta));
    expect_near(camera.position, eye, 1e-5f);
    expect_near(camera.generate_ray({0.5f, 0.5f}, 1.0f).direction, (target - eye) / 4.0f, 1e-5f);
    EXPECT_GE(camera.up.y, -1e-5f);
    EXPECT_NEAR(camera.right.y, 0.0f, 1e-6f);
  }
}

TEST(Orbit, FrontAndPoles_HaveAFrame) {
  const Camera front = orbit(Vec3(0.0f), 0.0f, k_pi / 2.0f, 2.0f, 0.7f);
  expect_near(front.position, {0, 0, 2}, 1e-6f);
  expect_near(front.right, {1, 0, 0}, 1e-6f);
  for (const float phi : {0.0f, k_pi}) {
    const Camera pole = orbit(Vec3(0.0f), 0.0f, phi, 2.0f, 0.7f);
    EXPECT_NEAR(dot(pole.right, pole.backward), 0.0f, 1e-6f);
    EXPECT_NEAR(length(cross(pole.right, pole.up)), 1.0f, 1e-5f);
  }
}

TEST(LookAt, StraightDown_IsFinite) {
  const Camera camera = look_at({0, 5, 0}, Vec3(0.0f), 0.7f);
  expect_near(camera.backward, {0, 1, 0}, 0.0f);
  EXPECT_TRUE(is_finite(camera.right));
  EXPECT_TRUE(is_finite(look_at(Vec3(1.0f), Vec3(1.0f), 0.7f).right));
}

TEST(FrameBounds, EveryCorner_IsInTheImageAndOneIsNearItsEdge) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    Bounds bounds;
    bounds.add(random.cube(10.0f));
    bounds.add(random.cube(10.0f));
    const float aspect = random.uniform(0.3f, 3.0f);
    const Camera camera = frame_bounds(bounds, aspect);
    float farthest = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 pick((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
      const Vec3 point = bounds.lower + pick * bounds.size();
      ASSERT_GT(camera.depth(point), 0.0f);
      const Vec2 from_center = glm::abs(project(camera, point, aspect) - 0.5f);
      farthest = std::max({farthest, from_center.x, from_center.y});
    }
    ASSERT_LE(farthest, 0.5f);
    ASSERT_GE(farthest, 0.45f);
  }
}

TEST(FrameBounds, EmptyAndSinglePoint_AreFinite) {
  EXPECT_TRUE(is_finite(frame_bounds(Bounds{}, 1.5f).position));
  Bounds point;
  point.add(Vec3(2.0f));
  EXPECT_TRUE(is_finite(frame_bounds(point, 1.5f).position));
}

TEST(Camera, Depth_IsAlongTheViewingAxis) {
  Camera camera;
  camera.position = {0, 0, 5};
  EXPECT_FLOAT_EQ(camera.depth({3, 4, 1}), 4.0f);
}

}  // namespace
}  // namespace lume::geometry
