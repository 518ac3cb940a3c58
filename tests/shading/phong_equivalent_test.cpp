// SPDX-License-Identifier: Apache-2.0
// What of a metallic-roughness material stands for which of the course's coefficients.
#include "shading/phong_equivalent.h"

#include "shading/bsdf.h"
#include "shading/microfacet.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::shading {
namespace {

using test::expect_near;
using test::Random;

struct Surface {
  Material material;
  MaterialPoint point;

  Surface() {
    point.material = &material;
    point.normal = {0, 0, 1};
  }
};

/// The same surface, described by the course's coefficients.
Surface described_by_phong(const Surface& surface) {
  Surface result;
  result.material = surface.material;
  result.material.phong = equivalent_phong(surface.point);
  result.point.base_color = surface.point.base_color;
  return result;
}

TEST(EquivalentPhong, Coefficients_FollowTheTable) {
  Surface surface;
  surface.point.base_color = Color(0.8f, 0.4f, 0.2f);
  surface.point.metallic = 0.25f;
  surface.point.roughness = 0.5f;
  surface.point.transmission = 0.5f;
  const Phong phong = equivalent_phong(surface.point);
  EXPECT_FLOAT_EQ(phong.ambient, 0.75f * 0.5f);
  EXPECT_FLOAT_EQ(phong.diffuse, 0.75f * 0.5f);
  EXPECT_FLOAT_EQ(phong.transmission, 0.75f * 0.5f);
  EXPECT_EQ(phong.transmission_color, surface.point.base_color);
  const Color specular = 0.75f * Color(0.04f) + 0.25f * surface.point.base_color;
  expect_near(phong.specular * phong.specular_color, specular, 1e-6f);
  expect_near(phong.reflection * phong.specular_color, specular, 1e-6f);
  EXPECT_EQ(phong.glossiness, phong.shininess);
  EXPECT_TRUE(phong.fresnel);
  surface.point.roughness = 0.0f;
  EXPECT_TRUE(std::isinf(equivalent_phong(surface.point).glossiness));
}

TEST(EquivalentPhong, APhongMaterial_IsItself) {
  Surface surface;
  surface.material.phong.emplace().shininess = 7.0f;
  EXPECT_EQ(equivalent_phong(surface.point).shininess, 7.0f);
  EXPECT_EQ(equivalent_phong(surface.point).fresnel, false);
}

TEST(EquivalentPhong, MatteSurface_IsTheSameToEveryLight) {
  Random random(1);
  Surface matte;
  matte.material.ior = 1.0f;  // no layer on top
  matte.point.base_color = Color(0.8f, 0.4f, 0.2f);
  Surface phong = described_by_phong(matte);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 v = random.upper_direction();
    const Vec3 l = random.direction();
    const Bsdf a(matte.point, v, false);
    const Bsdf b(phong.point, v, false);
    expect_near(a.eval_diffuse(l), b.eval_diffuse(l), 1e-6f);
    expect_near(a.ambient(), b.ambient(), 1e-6f);
    ASSERT_EQ(b.eval_specular(l), Color(0.0f));
  }
}

TEST(EquivalentPhong, MirrorSeenAlongTheNormal_IsTheSame) {
  Surface mirror;
  mirror.point.base_color = Color(1.0f, 0.7f, 0.3f);
  mirror.point.metallic = 1.0f;
  mirror.point.roughness = 0.0f;
  mirror.material.ior = 0.0f;
  Surface phong = described_by_phong(mirror);
  phong.material.phong->fresnel = false;  // a metal's colour holds it
  const Vec3 up(0, 0, 1);
  const auto a = Bsdf(mirror.point, up, false).sample_reflection({0.3f, 0.6f});
  const auto b = Bsdf(phong.point, up, false).sample_reflection({0.3f, 0.6f});
  ASSERT_TRUE(a && b);
  expect_near(a->direction, b->direction, 1e-6f);
  expect_near(a->weight, b->weight, 1e-6f);
}

TEST(EquivalentPhong, Shininess_HalvesWhereTheSlopesDo) {
  for (const float roughness : {0.05f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f}) {
    const float alpha = roughness * roughness;
    // The angle at which the density of slopes has fallen to half, by bisection.
    double low = 0.0;
    double high = M_PI / 4.0;
    const auto density = [&](double theta) {
      const Vec3 h(static_cast<float>(std::sin(theta)), 0.0f, static_cast<float>(std::cos(theta)));
      const float of_slopes = h.z * h.z * h.z * h.z;
      return ggx_distribution(h, alpha) * of_slopes / ggx_distribution({0, 0, 1}, alpha);
    };
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (density(middle) > 0.5f ? low : high) = middle;
    }
    const double turned = std::cos(2.0 * low);
    EXPECT_NEAR(std::pow(turned, static_cast<double>(equivalent_shininess(alpha))), 0.5, 2e-3)
        << "roughness " << roughness;
  }
}

/// The diffuse part under even light, by the midpoint rule.
Color integrate_diffuse(const Bsdf& bsdf) {
  constexpr int k_steps = 400;
  Color sum(0.0f);
  for (int i = 0; i < k_steps; ++i) {
    const float z = (static_cast<float>(i) + 0.5f) / k_steps;
    // Around the normal nothing changes.
    sum += bsdf.eval_diffuse({std::sqrt(1.0f - z * z), 0.0f, z});
  }
  return sum * (2.0f * geometry::k_pi / k_steps);
}

TEST(Bsdf, Ambient_IsTheDiffusePartUnderEvenLight) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    Surface surface;
    surface.point.base_color = Color(random.uniform(), random.uniform(), random.uniform());
    surface.point.metallic = random.uniform();
    surface.point.transmission = i % 2 == 0 ? 0.0f : random.uniform();
    surface.material.ior = random.uniform(1.0f, 2.5f);
    const Vec3 v = random.upper_direction();
    const Bsdf gltf(surface.point, v, false);
    expect_near(gltf.ambient(), integrate_diffuse(gltf), 2e-4f);
    surface.material.phong.emplace();
    const Bsdf phong(surface.point, v, false);
    expect_near(phong.ambient(), integrate_diffuse(phong), 2e-4f);
  }
}

}  // namespace
}  // namespace lume::shading
