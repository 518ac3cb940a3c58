// SPDX-License-Identifier: Apache-2.0
// The light that shapes send to a place, against closed forms.
#include "renderer/emitters.h"
#include "tests/renderer/lamp.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lume::renderer {
namespace {

using geometry::Disk;
using geometry::DMat4;
using geometry::DVec3;
using geometry::Plane;
using geometry::Sphere;
using shading::Scene;
using test::lamp;
using test::Random;

constexpr double k_pi = M_PI;

/// Illuminance (lux) by samples; what faces away gives nothing.
double illuminance(const Scene& scene, const Vec3& from, const Vec3& normal, int samples = 200000) {
  const Emitters emitters(scene);
  Random random(7);
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const EmitterSample s = emitters.sample(random.uniform(), random.square(), from);
    const Vec3 to_light = normalize(s.position - from);
    const float cosine = dot(normal, to_light);
    const bool shows = scene.materials[0].double_sided || dot(s.normal, to_light) < 0.0f;
    if (s.pdf > 0.0f && cosine > 0.0f && shows) sum += static_cast<double>(cosine / s.pdf);
  }
  return sum / samples;
}

/// E = pi L (r/d)^2 cos(theta) for a sphere wholly above the horizon: what a disk of its solid
/// angle's projection gives.
TEST(EmitterIlluminance, SphereAboveTheHorizon_HasItsIlluminance) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const double radius = random.uniform(0.1f, 2.0f);
    const Vec3 center = 4.0f * random.direction() + Vec3(0, 0, 5);
    if (center.z < radius) continue;
    const double d = length(center);
    if (radius > 0.99 * d) continue;
    const Scene scene = lamp(Sphere{radius}, test::translation(center.x, center.y, center.z));
    const double expected = k_pi * radius * radius / (d * d) * center.z / d;
    EXPECT_NEAR(illuminance(scene, Vec3(0.0f), {0, 0, 1}, 20000), expected, 0.02 * expected);
  }
}

TEST(EmitterIlluminance, InsideASphere_IlluminanceIsPi) {
  Scene scene = lamp(Sphere{2.0}, test::mirrored_shear());
  scene.materials[0].double_sided = true;
  const Vec3 from(0.6f, 1.1f, -2.2f);
  EXPECT_NEAR(illuminance(scene, from, {0, 0, 1}, 1000000), k_pi, 0.03);
  scene.materials[0].double_sided = false;
  EXPECT_EQ(illuminance(scene, from, {0, 0, 1}, 1000), 0.0) << "the inside is its back";
}

/// Lambert 1760: E = L/2 sum over the edges of the angle each fills, times the cosine between the
/// receiver's normal and the normal of the plane through the edge and the receiver.
double lambert(const std::array<DVec3, 4>& corners, const DVec3& from, const DVec3& normal) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const DVec3 a = glm::normalize(corners[i] - from);
    const DVec3 b = glm::normalize(corners[(i + 1) % 4] - from);
    sum += std::acos(dot(a, b)) * dot(glm::normalize(cross(a, b)), normal);
  }
  return 0.5 * std::abs(sum);
}

TEST(EmitterIlluminance, Rectangle_HasLambertsIlluminance) {
  Random random(6);
  const double half_x = 0.5 * 1.5;
  const double half_z = 0.5 * 0.4;
  for (int i = 0; i < 10; ++i) {
    DMat4 matrix = test::random_transform(random, 0.5f);
    matrix[3].z = 12.0 + random.uniform();  // all of it above the receiver
    const geometry::Transform transform(matrix);
    Scene scene = lamp(Plane{2.0 * half_x, 2.0 * half_z}, matrix);
    scene.materials[0].double_sided = true;
    std::array<DVec3, 4> corners = {DVec3(-half_x, 0, -half_z), DVec3(half_x, 0, -half_z),
                                    DVec3(half_x, 0, half_z), DVec3(-half_x, 0, half_z)};
    for (DVec3& corner : corners) corner = transform.point_to_world(corner);
    const double expected = lambert(corners, DVec3(0.0), {0, 0, 1});
    EXPECT_NEAR(illuminance(scene, Vec3(0.0f), {0, 0, 1}), expected, 0.02 * expected);
  }
}

/// E = pi L r^2 / (r^2 + h^2) under the middle of a disk; a hole takes its own share away.
TEST(EmitterIlluminance, DiskOnItsAxis_HasItsIlluminance) {
  const auto full = [](double r, double h) { return k_pi * r * r / (r * r + h * h); };
  for (const double h : {0.5, 2.0, 10.0}) {
    const Vec3 from(0.0f, static_cast<float>(h), 0.0f);
    const double disk = full(1.2, h);
    EXPECT_NEAR(illuminance(lamp(Disk{1.2, 0.0}), from, {0, -1, 0}), disk, 0.01 * disk);
    const double ring = disk - full(0.9, h);
    EXPECT_NEAR(illuminance(lamp(Disk{1.2, 0.9}), from, {0, -1, 0}), ring, 0.01 * ring);
    EXPECT_EQ(illuminance(lamp(Disk{1.2, 0.0}), -from, {0, 1, 0}, 1000), 0.0) << "its back";
  }
}

}  // namespace
}  // namespace lume::renderer
