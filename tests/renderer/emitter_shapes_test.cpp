// SPDX-License-Identifier: Apache-2.0
#include "renderer/emitter_shapes.h"

#include "geometry/refine.h"
#include "renderer/emitters.h"
#include "tests/renderer/lamp.h"
#include "tests/support/cases.h"
#include "tests/support/chi_squared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace lume::renderer {
namespace {

using geometry::Disk;
using geometry::DMat4;
using geometry::DVec3;
using geometry::Plane;
using geometry::Shape;
using geometry::Sphere;
using shading::Scene;
using test::lamp;
using test::mirrored_shear;
using test::Random;

constexpr double k_pi = M_PI;

/// Where the ray first meets the scene's one shape.
std::optional<geometry::SurfacePoint> meet(const Scene& scene, const Vec3& from,
                                           const Vec3& direction) {
  const geometry::Hit hit{0, 0, 0};
  const geometry::Ray ray{.origin = from, .direction = direction};
  const auto crossing = first_crossing(scene.world.geometry(hit),
                                       to_object(scene.world.transform(hit), ray), hit, nullptr);
  if (!crossing) return std::nullopt;
  return surface_point(scene.world, ray, hit, *crossing);
}

/// The density of a direction, by tracing it.
double traced_pdf(const Scene& scene, const Emitters& emitters, const Vec3& from,
                  const Vec3& direction) {
  const auto met = meet(scene, from, direction);
  return met ? static_cast<double>(emitters.pdf(*met, from)) : 0.0;
}

/// Directions from `from` against the density that tracing them finds, in the smallest cap around
/// their mean that holds them all.
void expect_density(const Scene& scene, const Vec3& from) {
  constexpr int k_samples = test::cases(40000);
  constexpr int k_steps =
      LUME_SANITIZED ? 30 : 60;  // fine, because the density ends abruptly at the shape's outline
  const Emitters emitters(scene);
  Random random(3);
  std::vector<DVec3> directions;
  DVec3 mean(0.0);
  for (int i = 0; i < k_samples; ++i) {
    const EmitterSample s = emitters.sample(random.uniform(), random.square(), from);
    directions.push_back(glm::normalize(DVec3(s.position) - DVec3(from)));
    mean += directions.back();
  }
  const geometry::Frame frame = geometry::make_frame(Vec3(glm::normalize(mean)));
  double lowest = 1.0;
  for (DVec3& w : directions) {
    w = {dot(w, DVec3(frame.tangent)), dot(w, DVec3(frame.bitangent)), dot(w, DVec3(frame.normal))};
    lowest = std::min(lowest, w.z);
  }
  lowest = std::max(-1.0, 1.0 - 1.02 * (1.0 - lowest));
  test::SphereCells cells(10, 12, lowest);
  for (const DVec3& w : directions) cells.count(w);
  const auto pdf = [&](double x, double y, double z) {
    return traced_pdf(scene, emitters, from, frame.to_world(Vec3(DVec3(x, y, z))));
  };
  EXPECT_NEAR(cells.expect(pdf, k_samples, k_steps), 1.0, 5e-3);
  cells.test();
}

std::vector<Shape> shapes() {
  return {Sphere{0.7}, Plane{1.5, 0.4}, Disk{0.8, 0.0}, Disk{0.8, 0.5}};
}

TEST(EmitterShapes, Directions_FollowTheDensity) {
  for (const Shape& shape : shapes()) {
    expect_density(lamp(shape, test::translation(1, 2, 3)), {-1.0f, 4.0f, 2.0f});
    const Scene sheared = lamp(shape, mirrored_shear());
    ASSERT_LT(glm::determinant(sheared.world.instances[0].transform.linear()), 0.0);
    expect_density(sheared, {1.0f, 4.0f, -3.5f});
  }
}

/// The point of a shape at texture coordinates, if it has one there.
std::optional<geometry::ShapePoint> at_uv(const Shape& shape, double u, double v) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    const double ring = std::sin(k_pi * v);
    const double turn = 2.0 * k_pi * (u - 0.5);
    return sphere->point({ring * std::sin(turn), std::cos(k_pi * v), ring * std::cos(turn)}, {});
  }
  const DVec3 middle(u - 0.5, 0.0, v - 0.5);
  if (const auto* plane = std::get_if<Plane>(&shape)) {
    return plane->point(middle * DVec3(plane->size_x, 0.0, plane->size_z), {});
  }
  const auto& disk = std::get<Disk>(shape);
  const DVec3 p = 2.0 * disk.radius * middle;
  if (length(p) < disk.inner_radius || length(p) > disk.radius) return std::nullopt;
  return disk.point(p, {});
}

/// The probability of a unit of (u, v): the density of the direction times |dP/du x dP/dv| cos /
/// d^2.
double density_of_uv(const Scene& scene, const Emitters& emitters, const Vec3& from,
                     const geometry::ShapePoint& point) {
  const geometry::Transform& transform = scene.world.instances[0].transform;
  const DVec3 position = transform.point_to_world(point.position);
  geometry::SurfacePoint met;
  met.position = Vec3(position);
  met.geometric_normal = Vec3(glm::normalize(transform.normal_to_world(point.normal)));
  const DVec3 area =
      cross(transform.vector_to_world(point.dp_du), transform.vector_to_world(point.dp_dv));
  const DVec3 offset = position - DVec3(from);
  return static_cast<double>(emitters.pdf(met, from)) * std::abs(dot(area, offset)) /
         std::pow(length(offset), 3.0);
}

/// However slender the shape seems from there, its texture coordinates fill the same square.
TEST(EmitterShapes, RandomTransforms_FollowTheDensity) {
  constexpr int k_cells = 12;
  constexpr int k_steps = 12 * k_cells;
  constexpr int k_samples = 20000;
  Random random(21);
  for (int i = 0; i < 40; ++i) {
    const Shape shape = shapes()[random.below(4)];
    const Scene scene = lamp(shape, test::random_transform(random, 3.0f));
    const Emitters emitters(scene);
    const geometry::Transform& transform = scene.world.instances[0].transform;
    const Vec3 from(transform.point_to_world(DVec3(random.cube(1.5f))));  // now and then inside
    std::vector<double> observed(k_cells * k_cells, 0.0);
    for (int j = 0; j < k_samples; ++j) {
      const Vec2 uv = emitters.sample(random.uniform(), random.square(), from).uv;
      const Vec2 cell = glm::min(glm::floor(uv * float{k_cells}), Vec2(k_cells - 1));
      observed[static_cast<std::size_t>(cell.y * k_cells + cell.x)] += 1.0;
    }
    std::vector<double> expected(k_cells * k_cells, 0.0);
    for (int j = 0; j < k_steps * k_steps; ++j) {
      const int x = j % k_steps;
      const int y = j / k_steps;
      const auto point = at_uv(shape, (x + 0.5) / k_steps, (y + 0.5) / k_steps);
      if (!point) continue;
      expected[static_cast<std::size_t>(y * k_cells / k_steps * k_cells + x * k_cells / k_steps)] +=
          density_of_uv(scene, emitters, from, *point) * k_samples / (k_steps * k_steps);
    }
    EXPECT_NEAR(std::accumulate(expected.begin(), expected.end(), 0.0) / k_samples, 1.0, 0.01);
    SCOPED_TRACE(i);
    test::expect_chi_squared(observed, expected);
  }
}

TEST(EmitterShapes, SphereNearFarAndFromInside_FollowsTheDensity) {
  for (const DMat4& matrix : {DMat4(1.0), mirrored_shear()}) {
    const Scene scene = lamp(Sphere{1.0}, matrix);
    const geometry::Transform transform(matrix);
    for (const double height : {1.02, 60.0, 0.0, 0.98}) {
      SCOPED_TRACE(height);
      const DVec3 from = transform.point_to_world(height * glm::normalize(DVec3(1, 2, -1)));
      expect_density(scene, Vec3(from));
    }
  }
}

TEST(EmitterShapes, SampleAndPdf_AgreeToTheLastBit) {
  Random random(4);
  for (int i = 0; i < 4000; ++i) {
    const Scene scene = lamp(shapes()[random.below(4)], test::random_transform(random, 3.0f));
    const Emitters emitters(scene);
    const Vec3 from = random.cube(6.0f);
    const EmitterSample s = emitters.sample(random.uniform(), random.square(), from);
    geometry::SurfacePoint met;
    met.hit = s.hit;
    met.position = s.position;
    met.geometric_normal = s.normal;
    ASSERT_EQ(emitters.pdf(met, from), s.pdf);
    // A ray that is aimed at the sample meets it, and finds the same density but for rounding.
    const Vec3 direction = normalize(s.position - from);
    if (std::abs(dot(direction, s.normal)) < 0.01f) continue;
    const auto traced = meet(scene, from, direction);
    if (!traced) continue;  // one rounding beyond an edge
    ASSERT_LT(length(traced->position - s.position), 1e-4f * (1.0f + length(from - s.position)));
    ASSERT_NEAR(emitters.pdf(*traced, from), s.pdf, 1e-3f * s.pdf);
    ASSERT_LT(length(traced->uv - s.uv), 1e-2f) << "texture coordinates";
    ASSERT_GT(dot(traced->geometric_normal, s.normal), 0.99f);
  }
}

TEST(EmitterShapes, FarSideOfASphere_HasNoDensity) {
  const Scene scene = lamp(Sphere{1.0});
  const Emitters emitters(scene);
  geometry::SurfacePoint met;
  met.position = {0, 0, 1};
  met.geometric_normal = {0, 0, 1};
  EXPECT_GT(emitters.pdf(met, {0, 0, 5}), 0.0f);
  EXPECT_EQ(emitters.pdf(met, {0, 0, -5}), 0.0f);
  EXPECT_NEAR(emitters.pdf(met, {0, 0, -0.5f}), 1.0 / (4.0 * k_pi), 1e-7);  // from inside
}

/// A sphere of radius r at distance d fills 2 pi (1 - sqrt(1 - (r/d)^2)) ~ pi (r/d)^2 steradians.
TEST(EmitterShapes, TinySphere_KeepsItsAccuracy) {
  for (const double radius : {1e-3, 1e-6, 1e-9}) {
    const Scene scene = lamp(Sphere{radius});
    const EmitterSample s = Emitters(scene).sample(0.5f, {0.3f, 0.6f}, {0, 0, 100});
    const double expected = 1.0 / (k_pi * radius * radius / 1e4);
    EXPECT_NEAR(s.pdf, expected, 1e-6 * expected);
    EXPECT_NEAR(length(s.position), radius, 1e-6 * radius);
  }
}

TEST(EmitterShapes, WorldArea_IsThatOfTheTransformedShape) {
  DMat4 prolate(1.0);
  prolate[2][2] = -3.0;
  const double e = std::sqrt(1.0 - 1.0 / 9.0);
  const double spheroid = 2.0 * k_pi * (1.0 + 3.0 / e * std::asin(e));
  EXPECT_NEAR(world_area(Sphere{1.0}, geometry::Transform(prolate)), spheroid, 0.01 * spheroid);
  DMat4 doubled(2.0);
  doubled[3][3] = 1.0;
  EXPECT_NEAR(world_area(Sphere{0.5}, geometry::Transform(doubled)), 4.0 * k_pi, 1e-12);
  const geometry::Transform transform(mirrored_shear());
  const double stretch = length(cross(transform.linear()[0], transform.linear()[2]));
  EXPECT_NEAR(world_area(Plane{1.5, 0.4}, transform), 0.6 * stretch, 1e-12);
  EXPECT_NEAR(world_area(Disk{0.8, 0.5}, transform), k_pi * 0.39 * stretch, 1e-12);
}

}  // namespace
}  // namespace lume::renderer
