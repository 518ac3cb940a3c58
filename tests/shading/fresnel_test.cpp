// SPDX-License-Identifier: Apache-2.0
#include "shading/fresnel.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::shading {
namespace {

using test::Random;

TEST(Fresnel, NormalIncidence_IsTheClosedForm) {
  EXPECT_NEAR(normal_reflectance(1.5f), 0.04f, 1e-7f);
  for (const float ior : {1.0f, 1.33f, 1.5f, 2.42f}) {
    EXPECT_NEAR(fresnel_dielectric(1.0f, 1.0f / ior), normal_reflectance(ior), 1e-6f);
    EXPECT_NEAR(fresnel_dielectric(1.0f, ior), normal_reflectance(ior), 1e-6f);
  }
}

TEST(Fresnel, Grazing_ReflectsEverything) {
  EXPECT_NEAR(fresnel_dielectric(1e-6f, 1.0f / 1.5f), 1.0f, 1e-4f);
  EXPECT_NEAR(fresnel_schlick(0.04f, 1.0f, 0.0f), 1.0f, 1e-6f);
}

TEST(Fresnel, IndexOne_IsNoBoundary) {
  const float f0 = normal_reflectance(1.0f);
  EXPECT_EQ(fresnel_schlick(f0, grazing_reflectance(f0), 0.1f), 0.0f);
  EXPECT_EQ(grazing_reflectance(normal_reflectance(1.33f)), 1.0f);
}

TEST(Fresnel, SchlicksAverage_IsItsCosineWeightedMean) {
  constexpr int k_steps = 10000;
  double mean = 0.0;
  for (int i = 0; i < k_steps; ++i) {
    const double cosine = (i + 0.5) / k_steps;  // the integral of 2 cos F d(cos)
    mean += 2.0 * cosine / k_steps *
            static_cast<double>(fresnel_schlick(0.04f, 1.0f, static_cast<float>(cosine)));
  }
  EXPECT_NEAR(fresnel_schlick_average(0.04f, 1.0f), mean, 1e-5);
}

TEST(Fresnel, BrewstersAngle_ReflectsThePerpendicularHalfOnly) {
  // At tan(angle) = n the parallel part vanishes and the perpendicular one is ((1-n^2)/(1+n^2))^2.
  for (const double n : {1.33, 1.5, 2.0}) {
    const double cosine = std::cos(std::atan(n));
    const double perpendicular = (1.0 - n * n) / (1.0 + n * n);
    EXPECT_NEAR(fresnel_dielectric(static_cast<float>(cosine), static_cast<float>(1.0 / n)),
                0.5 * perpendicular * perpendicular, 1e-6);
  }
}

TEST(Fresnel, TotalInternalReflection_BeginsAtTheCriticalAngle) {
  const double n = 1.5;
  const double critical = std::asin(1.0 / n);
  const auto at = [&](double angle) {
    return fresnel_dielectric(static_cast<float>(std::cos(angle)), static_cast<float>(n));
  };
  EXPECT_EQ(at(critical + 1e-4), 1.0f);
  EXPECT_LT(at(critical - 1e-3), 1.0f);
  const Vec3 normal(0, 0, 1);
  const auto ray = [&](double angle) {
    const Vec3 v(static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle)));
    return refract(v, normal, static_cast<float>(n));
  };
  EXPECT_FALSE(ray(critical + 1e-4));
  EXPECT_TRUE(ray(critical - 1e-4));
}

TEST(Refract, RandomDirections_ObeySnellInThePlaneOfIncidence) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 normal = random.direction();
    Vec3 v = random.direction();
    if (dot(v, normal) < 0.0f) v = -v;
    const float eta = random.uniform(0.4f, 1.0f);
    const auto refracted = refract(v, normal, eta);
    ASSERT_TRUE(refracted);
    ASSERT_NEAR(length(*refracted), 1.0f, 1e-5f);
    ASSERT_LT(dot(*refracted, normal), 0.0f);
    const Vec3 sine_in = cross(normal, v);
    const Vec3 sine_out = cross(normal, *refracted);
    ASSERT_LT(length(sine_out + eta * sine_in), 1e-5f);  // n1 sin1 = n2 sin2, on opposite sides
    // Light takes the same way back.
    const auto back = refract(*refracted, -normal, 1.0f / eta);
    ASSERT_TRUE(back);
    ASSERT_LT(length(*back - v), 2e-3f);
  }
}

TEST(Reflect, RandomDirections_MirrorAtTheNormal) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 normal = random.direction();
    const Vec3 v = random.direction();
    const Vec3 r = reflect(v, normal);
    ASSERT_NEAR(dot(r, normal), dot(v, normal), 1e-5f);
    ASSERT_LT(length(cross(normal, r) + cross(normal, v)), 1e-5f);
  }
}

}  // namespace
}  // namespace lume::shading
