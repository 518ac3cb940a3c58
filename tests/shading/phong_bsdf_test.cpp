// SPDX-License-Identifier: Apache-2.0
// The course's terms against values found by hand and against formulas of other form.
#include "shading/phong_bsdf.h"

#include "shading/fresnel.h"
#include "tests/support/chi_squared.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::shading {
namespace {

using geometry::DVec3;
using geometry::k_pi;
using test::expect_near;
using test::Random;

/// A point with normal +z unless it is given.
struct Surface {
  Material material;
  MaterialPoint point;

  explicit Surface(const Phong& phong, float ior = 1.5f) {
    material.phong = phong;
    material.ior = ior;
    point.normal = {0, 0, 1};
  }
  [[nodiscard]] PhongBsdf seen_from(const Vec3& to_viewer, bool inside = false) {
    point.material = &material;
    return {point, to_viewer, inside};
  }
};

/// A unit vector at an angle from +z (degrees), in the plane y = 0.
Vec3 at_angle(double degrees) {
  const double angle = degrees * M_PI / 180.0;
  return {static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle))};
}

TEST(PhongBsdf, Terms_AreTheCoursesByHand) {
  Phong phong;
  phong.ambient = 0.25f;
  phong.ambient_color = Color(1.0f, 0.5f, 0.5f);
  phong.diffuse = 0.5f;
  phong.diffuse_color = Color(0.5f, 1.0f, 1.0f);
  phong.specular = 0.75f;
  phong.specular_color = Color(1.0f, 0.5f, 0.25f);
  phong.shininess = 3.0f;
  phong.reflection = 0.6f;
  phong.transmission = 0.4f;
  phong.transmission_color = Color(0.0f, 0.5f, 1.0f);
  Surface surface(phong);
  surface.point.base_color = Color(0.8f, 0.4f, 0.2f);
  const PhongBsdf bsdf = surface.seen_from(at_angle(60.0));
  expect_near(bsdf.ambient(), {0.2f, 0.05f, 0.025f}, 1e-7f);
  // (n.l) = 1/2 at 60 degrees from the normal, on either side.
  const Color half_diffuse = Color(0.2f, 0.2f, 0.1f) * 0.5f / k_pi;
  expect_near(bsdf.eval_diffuse(at_angle(-60.0)), half_diffuse, 1e-7f);
  expect_near(bsdf.eval_diffuse(at_angle(60.0)), half_diffuse, 1e-7f);
  // The viewer stands where the light at -60 degrees is mirrored: (r.v) = 1; 60 degrees away from
  // it, at 0, (r.v)^3 = 1/8; at +60 degrees r and v are 120 degrees apart.
  const Color highlight = Color(0.75f, 0.375f, 0.1875f) / k_pi;
  expect_near(bsdf.eval_specular(at_angle(-60.0)), highlight, 1e-6f);
  expect_near(bsdf.eval_specular(at_angle(0.0)), highlight / 8.0f, 1e-6f);
  expect_near(bsdf.eval_specular(at_angle(60.0)), Color(0.0f), 1e-7f);
  // A light 30 degrees from the mirror direction but below the surface.
  EXPECT_EQ(bsdf.eval_specular(at_angle(-91.0)), Color(0.0f));
  EXPECT_EQ(bsdf.eval_diffuse(at_angle(-91.0)), Color(0.0f));
  expect_near(bsdf.reflection_color(), {0.6f, 0.3f, 0.15f}, 1e-7f);
  expect_near(bsdf.transmission_color(), {0.0f, 0.2f, 0.4f}, 1e-7f);
}

TEST(PhongBsdf, Reflection_KeepsTheAngleAndThePlane) {
  Random random(1);
  Phong phong;
  phong.reflection = 1.0f;
  Surface surface(phong);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 n = random.direction();
    Vec3 v = random.direction();
    if (dot(v, n) < 0.0f) v = -v;
    surface.point.normal = n;
    const auto sample = surface.seen_from(v).sample_reflection(random.square());
    ASSERT_TRUE(sample);
    // Half a turn around the normal: the part along it stays, the part across it turns over.
    const DVec3 along = dot(DVec3(v), DVec3(n)) * DVec3(n);
    const DVec3 expected = along - (DVec3(v) - along);
    ASSERT_LT(length(DVec3(sample->direction) - expected), 1e-6);
    ASSERT_EQ(sample->weight, Color(1.0f));
  }
}

/// Whitted 1980, p. 345, in double: P = k_f (N + V') - N with V' = V / |V.N| and
/// k_f = (k_n^2 |V'|^2 - |V' + N|^2)^(-1/2), where V runs to the surface and k_n is the index
/// beyond it over that on the side it comes from. Not a number beyond the critical angle.
DVec3 whitted_refraction(const DVec3& v, const DVec3& n, double k_n) {
  const DVec3 scaled = v / std::abs(dot(v, n));
  const double k_f = 1.0 / std::sqrt(k_n * k_n * dot(scaled, scaled) - dot(scaled + n, scaled + n));
  return normalize(k_f * (n + scaled) - n);
}

TEST(PhongBsdf, Refraction_IsWhittedsAndSnells) {
  Random random(2);
  Phong phong;
  phong.transmission = 1.0f;
  int refracted = 0;
  for (int i = 0; i < 20000; ++i) {
    const float ior = random.uniform(1.0f, 3.0f);
    const bool inside = i % 2 == 1;
    Surface surface(phong, ior);
    const Vec3 n = random.direction();
    Vec3 v = random.direction();
    if (dot(v, n) < 0.0f) v = -v;
    surface.point.normal = n;
    const auto sample = surface.seen_from(v, inside).sample_transmission();
    const double k_n = inside ? 1.0 / static_cast<double>(ior) : static_cast<double>(ior);
    const double sine = length(cross(DVec3(v), DVec3(n))) / k_n;
    if (std::abs(sine - 1.0) < 1e-3) continue;  // rounding decides
    ASSERT_EQ(sample.has_value(), sine < 1.0) << "ior " << ior;
    if (!sample) continue;
    ++refracted;
    ASSERT_LT(length(DVec3(sample->direction) - whitted_refraction(-DVec3(v), DVec3(n), k_n)),
              1e-4);
    ASSERT_NEAR(length(cross(DVec3(sample->direction), DVec3(n))), sine, 1e-5) << "Snell's law";
    ASSERT_LT(dot(sample->direction, n), 0.0f);
  }
  EXPECT_GT(refracted, 12000);
}

TEST(PhongBsdf, TotalReflection_BeginsAtTheCriticalAngle) {
  Phong phong;
  phong.reflection = 1.0f;
  phong.transmission = 1.0f;
  for (const float ior : {1.1f, 1.33f, 1.5f, 2.42f}) {
    const double critical = std::asin(1.0 / static_cast<double>(ior)) * 180.0 / M_PI;
    for (const bool fresnel : {false, true}) {
      phong.fresnel = fresnel;
      Surface surface(phong, ior);
      const PhongBsdf below = surface.seen_from(at_angle(critical - 0.01), true);
      const PhongBsdf beyond = surface.seen_from(at_angle(critical + 0.01), true);
      EXPECT_TRUE(below.sample_transmission()) << ior;
      EXPECT_FALSE(beyond.sample_transmission()) << ior;
      EXPECT_EQ(beyond.reflection_color(), Color(1.0f)) << "all of it, with Fresnel or without";
      EXPECT_TRUE(surface.seen_from(at_angle(89.9), false).sample_transmission())
          << "no such thing from outside";
    }
  }
}

TEST(PhongBsdf, Fresnel_SharesTheLightOut) {
  Phong phong;
  phong.reflection = 1.0f;
  phong.transmission = 1.0f;
  phong.fresnel = true;
  Surface surface(phong, 1.5f);
  const float normal_reflectance = surface.seen_from(at_angle(0.0)).reflection_color().x;
  EXPECT_NEAR(normal_reflectance, 0.04f, 1e-6f);  // ((1.5 - 1) / (1.5 + 1))^2
  for (int degrees = 0; degrees < 90; ++degrees) {
    const PhongBsdf bsdf = surface.seen_from(at_angle(degrees));
    const double cosine = std::cos(degrees * M_PI / 180.0);
    const double beyond = std::sqrt(1.0 - (1.0 - cosine * cosine) / (1.5 * 1.5));
    const double s = (cosine - 1.5 * beyond) / (cosine + 1.5 * beyond);
    const double p = (beyond - 1.5 * cosine) / (beyond + 1.5 * cosine);
    EXPECT_NEAR(bsdf.reflection_color().x, 0.5 * (s * s + p * p), 1e-5) << degrees;
    EXPECT_NEAR(bsdf.reflection_color().x + bsdf.transmission_color().x, 1.0f, 1e-6f);
  }
  surface.material.phong->fresnel = false;
  EXPECT_EQ(surface.seen_from(at_angle(80.0)).reflection_color(), Color(1.0f));
  EXPECT_EQ(surface.seen_from(at_angle(80.0)).transmission_color(), Color(1.0f));
}

TEST(PhongBsdf, GlossyReflection_FollowsTheLobe) {
  constexpr int k_samples = 200000;
  Random random(3);
  for (const float glossiness : {0.0f, 1.0f, 20.0f}) {
    Phong phong;
    phong.reflection = 0.5f;
    phong.glossiness = glossiness;
    Surface surface(phong);
    const PhongBsdf bsdf = surface.seen_from({0, 0, 1});  // the lobe stands on the surface
    test::SphereCells cells(16, 16, 0.0);
    for (int i = 0; i < k_samples; ++i) {
      const auto sample = bsdf.sample_reflection(random.square());
      ASSERT_TRUE(sample);
      ASSERT_EQ(sample->weight, Color(0.5f));
      cells.count(sample->direction);
    }
    const auto n = static_cast<double>(glossiness);
    const double integral = cells.expect(
        [n](double, double, double z) { return (n + 1.0) / (2.0 * M_PI) * std::pow(z, n); },
        k_samples, 16);
    EXPECT_NEAR(integral, 1.0, 1e-3);
    cells.test();
  }
}

TEST(PhongBsdf, GlossyReflection_NeverGoesIntoTheSurface) {
  Random random(4);
  Phong phong;
  phong.reflection = 1.0f;
  phong.glossiness = 2.0f;
  Surface surface(phong);
  const PhongBsdf bsdf = surface.seen_from(at_angle(75.0));
  int drawn = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto sample = bsdf.sample_reflection(random.square());
    if (!sample) continue;
    ++drawn;
    ASSERT_GT(sample->direction.z, 0.0f);
  }
  EXPECT_GT(drawn, 5000);
  EXPECT_LT(drawn, 10000);
}

TEST(PhongBsdf, StraightTransmittance_IsKtOt) {
  Phong phong;
  phong.transmission = 0.9f;
  phong.transmission_color = Color(1.0f, 0.5f, 0.0f);
  Surface surface(phong, 1.5f);
  surface.point.material = &surface.material;
  expect_near(phong_straight_transmittance(surface.point, 0.3f), {0.9f, 0.45f, 0.0f}, 1e-7f);
  surface.material.phong->fresnel = true;
  expect_near(phong_straight_transmittance(surface.point, 1.0f),
              Color(0.9f, 0.45f, 0.0f) * (1.0f - 0.04f), 1e-6f);
}

}  // namespace
}  // namespace lume::shading
