// SPDX-License-Identifier: Apache-2.0
#include "geometry/camera.h"

#include "geometry/disk.h"
#include "tests/support/chi_squared.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lume::geometry {
namespace {

using test::expect_near;
using test::Random;

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

/// A camera with a lens somewhere, of either projection.
Camera random_lens(Random& random) {
  const Vec3 eye = random.cube(5.0f);
  Camera camera = look_at(eye, eye + random.direction(), random.uniform(0.2f, 2.0f));
  if (random.below(2) == 0) camera.projection = Camera::Projection::orthographic;
  camera.half_height = random.uniform(0.1f, 5.0f);
  camera.lens_radius = random.uniform(0.001f, 0.5f);
  camera.focus_distance = random.uniform(0.5f, 20.0f);
  return camera;
}

Vec3 at_depth(const Camera& camera, const Ray& ray, float depth) {
  const float start = camera.depth(ray.origin);
  return ray.origin - ray.direction * ((depth - start) / dot(ray.direction, camera.backward));
}

/// A uniform grid over the square around the unit disk, and how much of each of its cells the disk
/// covers.
void expect_uniform_on_disk(const std::vector<Vec2>& points) {
  constexpr int k_cells = 16;
  constexpr int k_steps = 64;
  std::vector<double> observed(k_cells * k_cells, 0.0);
  for (const Vec2& p : points) {
    ASSERT_LE(length(p), 1.0f + 1e-4f);
    const auto cell = [](float x) {
      return std::clamp(static_cast<int>((x + 1.0f) / 2.0f * k_cells), 0, k_cells - 1);
    };
    observed[static_cast<std::size_t>(cell(p.y) * k_cells + cell(p.x))] += 1.0;
  }
  std::vector<double> expected(k_cells * k_cells, 0.0);
  const auto at = [](int i) { return 2.0 * (i + 0.5) / (k_cells * k_steps) - 1.0; };
  for (int j = 0; j < k_cells * k_steps; ++j) {
    for (int i = 0; i < k_cells * k_steps; ++i) {
      if (at(i) * at(i) + at(j) * at(j) > 1.0) continue;
      expected[static_cast<std::size_t>(j / k_steps * k_cells + i / k_steps)] += 1.0;
    }
  }
  double total = 0.0;
  for (const double e : expected) total += e;
  for (double& e : expected) e *= static_cast<double>(points.size()) / total;
  test::expect_chi_squared(observed, expected);
}

TEST(ConcentricDisk, CentreAndEdges_AreThemselves) {
  EXPECT_EQ(concentric_disk({0.5f, 0.5f}), Vec2(0.0f));
  EXPECT_NEAR(length(concentric_disk({1.0f, 0.5f}) - Vec2(1, 0)), 0.0f, 1e-6f);
  EXPECT_NEAR(length(concentric_disk({0.5f, 1.0f}) - Vec2(0, 1)), 0.0f, 1e-6f);
  EXPECT_NEAR(length(concentric_disk({0.0f, 0.5f}) - Vec2(-1, 0)), 0.0f, 1e-6f);
  EXPECT_NEAR(length(concentric_disk({0.5f, 0.0f}) - Vec2(0, -1)), 0.0f, 1e-6f);
  // A square half as large becomes a circle half as large, its corner at 45 degrees.
  EXPECT_NEAR(length(concentric_disk({0.75f, 0.75f}) - Vec2(std::sqrt(0.125f))), 0.0f, 1e-6f);
}

TEST(ConcentricDisk, Neighbours_StayNeighbours) {
  Random random(11);
  for (int i = 0; i < 10000; ++i) {
    const Vec2 a = random.square();
    const Vec2 b = a + 1e-3f * (random.square() - 0.5f);
    // The map's largest stretch is that of the diagonals' ends, pi / 2 a unit and a corner.
    ASSERT_LT(length(concentric_disk(a) - concentric_disk(b)), 3.5f * length(a - b) + 1e-6f);
  }
}

TEST(ThinLens, RaysOfOneImagePoint_MeetInThePlaneOfFocus) {
  Random random(12);
  for (int i = 0; i < 3000; ++i) {
    const Camera camera = random_lens(random);
    Camera pinhole = camera;
    pinhole.lens_radius = 0.0f;
    const Vec2 ndc = random.square();
    const Vec3 sharp = at_depth(camera, pinhole.generate_ray(ndc, 1.4f), camera.focus_distance);
    for (int j = 0; j < 4; ++j) {
      const Ray ray = camera.generate_ray(ndc, 1.4f, random.square());
      ASSERT_NEAR(length(ray.direction), 1.0f, 1e-6f);
      ASSERT_LT(dot(ray.direction, camera.backward), 0.0f);
      const Vec3 met = at_depth(camera, ray, camera.focus_distance);
      ASSERT_LT(length(met - sharp), 1e-5f * (1.0f + length(sharp - camera.position)));
    }
  }
}

TEST(ThinLens, Origins_AreUniformOnTheLens) {
  Random random(13);
  for (const auto projection :
       {Camera::Projection::perspective, Camera::Projection::orthographic}) {
    Camera camera = random_lens(random);
    camera.projection = projection;
    Camera pinhole = camera;
    pinhole.lens_radius = 0.0f;
    const Vec2 ndc(0.3f, 0.8f);
    const Vec3 center = pinhole.generate_ray(ndc, 1.0f).origin;
    std::vector<Vec2> points;
    for (int i = 0; i < 100000; ++i) {
      const Vec3 aside = camera.generate_ray(ndc, 1.0f, random.square()).origin - center;
      ASSERT_NEAR(dot(aside, camera.backward), 0.0f, 2e-6f);
      points.push_back(Vec2(dot(aside, camera.right), dot(aside, camera.up)) / camera.lens_radius);
    }
    expect_uniform_on_disk(points);
  }
}

/// A point at depth d, seen through a lens of diameter A, is spread in the plane of focus at f over
/// a circle of diameter A |f - d| / d: similar triangles with the point as their tip.
TEST(ThinLens, PointOutOfFocus_FillsTheCircleOfConfusion) {
  Random random(14);
  for (int i = 0; i < 300; ++i) {
    Camera camera = random_lens(random);
    camera.projection = Camera::Projection::perspective;
    const float d = camera.focus_distance * random.uniform(0.3f, 3.0f);
    const float f = camera.focus_distance;
    const Vec3 seen = camera.position - d * camera.backward +
                      0.1f * d * (random.uniform() * camera.right + random.uniform() * camera.up);
    const Vec3 center = camera.position + (seen - camera.position) * (f / d);
    const float expected = camera.lens_radius * std::abs(f - d) / d;
    float farthest = 0.0f;
    for (int j = 0; j < 64; ++j) {
      // From a point of the lens's edge through the point into the plane of focus. The camera must
      // trace this very ray for the image position of where it ends.
      const Vec2 lens(static_cast<float>(j % 8) / 8.0f, j < 32 ? 0.0f : 1.0f);
      const Vec2 edge = camera.lens_radius * concentric_disk(lens);
      const Vec3 from = camera.position + edge.x * camera.right + edge.y * camera.up;
      const Vec3 end = from + (seen - from) * (f / d);
      const Ray ray = camera.generate_ray(project(camera, end, 1.0f), 1.0f, lens);
      ASSERT_LT(length(at_depth(camera, ray, d) - seen), 2e-5f * (1.0f + d + f));
      farthest = std::max(farthest, length(end - center));
    }
    ASSERT_NEAR(farthest, expected, 1e-4f * expected + 1e-5f * f);
  }
}

TEST(ThinLens, FocusAtInfinity_RaysAreParallel) {
  Camera camera;
  camera.lens_radius = 0.1f;
  camera.focus_distance = std::numeric_limits<float>::infinity();
  const Vec3 middle = camera.generate_ray({0.2f, 0.7f}, 1.0f).direction;
  EXPECT_EQ(camera.generate_ray({0.2f, 0.7f}, 1.0f, {0.9f, 0.1f}).direction, middle);
}

TEST(ThinLens, RadiusZero_IsTheVeryPinhole) {
  Random random(15);
  for (int i = 0; i < 2000; ++i) {
    Camera camera = random_lens(random);
    camera.lens_radius = 0.0f;
    const Vec2 ndc = random.square();
    const Ray ray = camera.generate_ray(ndc, 1.3f, random.square());
    const float x = (2.0f * ndc.x - 1.0f) * 1.3f;
    const float y = 1.0f - 2.0f * ndc.y;
    const Vec3 on_image = x * camera.right + y * camera.up;
    if (camera.projection == Camera::Projection::orthographic) {
      ASSERT_EQ(ray.origin, camera.position + camera.half_height * on_image);
      ASSERT_EQ(ray.direction, -camera.backward);
    } else {
      ASSERT_EQ(ray.origin, camera.position);
      ASSERT_EQ(ray.direction,
                normalize(std::tan(0.5f * camera.vertical_fov) * on_image - camera.backward));
    }
  }
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
