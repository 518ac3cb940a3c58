// SPDX-License-Identifier: Apache-2.0
#include "shading/lights.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::shading {
namespace {

TEST(PunctualLight, Point_FallsOffWithTheSquareOfTheDistance) {
  PunctualLight light;
  light.intensity = Color(100.0f, 50.0f, 0.0f);
  light.position = {0, 4, 0};
  const Incidence incidence = illuminate(light, {0, 0, 3});
  EXPECT_FLOAT_EQ(incidence.distance, 5.0f);
  EXPECT_FLOAT_EQ(incidence.illuminance.x, 4.0f);
  EXPECT_FLOAT_EQ(incidence.illuminance.y, 2.0f);
  EXPECT_FLOAT_EQ(incidence.to_light.y, 0.8f);
  EXPECT_FLOAT_EQ(incidence.to_light.z, -0.6f);
}

TEST(PunctualLight, Range_IsWindowedAsTheExtensionRecommends) {
  PunctualLight light;
  light.range = 10.0f;
  const auto at = [&](float distance) { return illuminate(light, {distance, 0, 0}).illuminance.x; };
  EXPECT_FLOAT_EQ(at(5.0f), (1.0f - 0.0625f) / 25.0f);
  EXPECT_EQ(at(10.0f), 0.0f);
  EXPECT_EQ(at(11.0f), 0.0f);
}

TEST(PunctualLight, Directional_IsTheSameEverywhere) {
  PunctualLight light;
  light.kind = PunctualLight::Kind::directional;
  light.direction = {0, -1, 0};
  light.intensity = Color(3.0f);
  for (const Vec3& point : {Vec3(0.0f), Vec3(1e6f, -5.0f, 3.0f)}) {
    const Incidence incidence = illuminate(light, point);
    EXPECT_EQ(incidence.illuminance, Color(3.0f));
    EXPECT_EQ(incidence.to_light, Vec3(0, 1, 0));
    EXPECT_TRUE(std::isinf(incidence.distance));
  }
}

TEST(PunctualLight, Spot_IsFullInsideAndDarkOutsideItsCones) {
  PunctualLight light;
  light.kind = PunctualLight::Kind::spot;
  light.direction = {0, 0, -1};
  light.inner_cone = 0.3f;
  light.outer_cone = 0.6f;
  const auto at = [&](float angle) {
    return illuminate(light, {std::sin(angle), 0.0f, -std::cos(angle)}).illuminance.x;
  };
  EXPECT_FLOAT_EQ(at(0.0f), 1.0f);
  EXPECT_FLOAT_EQ(at(0.29f), 1.0f);
  EXPECT_EQ(at(0.61f), 0.0f);
  EXPECT_EQ(at(3.0f), 0.0f);
  const float ramp = (std::cos(0.45f) - std::cos(0.6f)) / (std::cos(0.3f) - std::cos(0.6f));
  EXPECT_NEAR(at(0.45f), ramp * ramp, 1e-5f);
}

TEST(PunctualLight, Attenuation_IsTheCourses) {
  PunctualLight light;
  light.intensity = Color(2.0f);
  light.position = {0, 5, 0};
  light.attenuation = Vec3(0.5f, 0.25f, 0.125f);
  const auto at = [&](float distance) {
    return illuminate(light, {0, 5.0f - distance, 0}).illuminance.x;
  };
  EXPECT_FLOAT_EQ(at(2.0f), 2.0f / 1.5f);  // 0.5 + 0.25 * 2 + 0.125 * 4
  EXPECT_FLOAT_EQ(at(4.0f), 2.0f / 3.5f);
  EXPECT_EQ(at(0.5f), 2.0f) << "never more than the light has";
  light.attenuation = Vec3(1.0f, 0.0f, 0.0f);
  EXPECT_EQ(at(1.0f), 2.0f);
  EXPECT_EQ(at(1000.0f), 2.0f) << "no falloff";
  light.range = 2000.0f;
  EXPECT_FLOAT_EQ(at(1000.0f), 2.0f * (1.0f - 0.0625f)) << "the range still ends it";
}

TEST(PunctualLight, PointAtTheLight_GetsNothing) {
  EXPECT_EQ(illuminate(PunctualLight{}, Vec3(0.0f)).illuminance, Color(0.0f));
}

}  // namespace
}  // namespace lume::shading
