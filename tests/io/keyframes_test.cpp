// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/keyframes.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace lume::io::gltf {
namespace {

using Row = std::vector<double>;

void expect_near(const Row& actual, const Row& expected, double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], tolerance) << "number " << i;
  }
}

Row about_z(double angle) { return {0.0, 0.0, std::sin(angle / 2), std::cos(angle / 2)}; }

Keyframes scalars(Interpolation interpolation, Row times, Row values) {
  return {interpolation, false, 1, std::move(times), std::move(values)};
}

TEST(Keyframes, Step_HoldsUntilTheNextKey) {
  const Keyframes keys = scalars(Interpolation::step, {1, 2, 4}, {10, 20, 40});
  EXPECT_EQ(sample(keys, 1.0), Row{10});
  EXPECT_EQ(sample(keys, std::nextafter(2.0, 0.0)), Row{10});
  EXPECT_EQ(sample(keys, 2.0), Row{20});
  EXPECT_EQ(sample(keys, 3.9), Row{20});
  EXPECT_EQ(sample(keys, 4.0), Row{40});
}

TEST(Keyframes, Linear_IsStraightBetweenKeys) {
  const Keyframes keys{Interpolation::linear, false, 2, {1, 3}, {0, 10, 4, 30}};
  EXPECT_EQ(sample(keys, 1.5), (Row{1, 15}));
  EXPECT_EQ(sample(keys, 1.0), (Row{0, 10}));
  EXPECT_EQ(sample(keys, 3.0), (Row{4, 30}));
}

TEST(Keyframes, OutsideTheKeys_TheNearestKeyHolds) {
  for (const Interpolation kind : {Interpolation::step, Interpolation::linear}) {
    const Keyframes keys = scalars(kind, {1, 2}, {5, 7});
    EXPECT_EQ(sample(keys, 0.0), Row{5});
    EXPECT_EQ(sample(keys, -1e300), Row{5});
    EXPECT_EQ(sample(keys, 1e300), Row{7});
  }
  const Keyframes spline = scalars(Interpolation::cubic_spline, {1, 2}, {100, 5, 100, 100, 7, 100});
  EXPECT_EQ(sample(spline, 0.0), Row{5});
  EXPECT_EQ(sample(spline, 9.0), Row{7});
}

TEST(Keyframes, OneKey_HoldsAlways) {
  const Keyframes spline = scalars(Interpolation::cubic_spline, {1}, {3, 5, 3});
  EXPECT_EQ(sample(spline, 0.0), Row{5});
  EXPECT_EQ(sample(spline, 1.0), Row{5});
  EXPECT_EQ(sample(spline, 2.0), Row{5});
}

TEST(Keyframes, Slerp_TurnsEvenly) {
  Keyframes keys{Interpolation::linear, true, 4, {0, 2}, about_z(0.2)};
  const Row last = about_z(1.4);
  keys.values.insert(keys.values.end(), last.begin(), last.end());
  for (const double s : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
    expect_near(sample(keys, 2 * s), about_z(0.2 + 1.2 * s), 1e-15);
  }
}

TEST(Keyframes, SlerpOfTheOtherSign_TakesTheShortWay) {
  Keyframes keys{Interpolation::linear, true, 4, {0, 1}, about_z(0.0)};
  for (const double number : about_z(1.0)) {
    keys.values.push_back(-number);  // the same rotation
  }
  expect_near(sample(keys, 0.5), about_z(0.5), 1e-15);
}

TEST(Keyframes, SlerpOfTinyAngle_KeepsItsDigits) {
  Keyframes keys{Interpolation::linear, true, 4, {0, 1}, about_z(0.0)};
  const Row last = about_z(1e-10);
  keys.values.insert(keys.values.end(), last.begin(), last.end());
  EXPECT_NEAR(sample(keys, 0.5)[2], 0.25e-10, 1e-24);
}

TEST(Keyframes, SlerpOfEqualRotations_StaysThere) {
  const Row q = about_z(0.7);
  Keyframes keys{Interpolation::linear, true, 4, {0, 1}, q};
  keys.values.insert(keys.values.end(), q.begin(), q.end());
  expect_near(sample(keys, 0.3), q, 1e-15);
}

TEST(Keyframes, RotationWithoutDirection_IsTheIdentity) {
  const Keyframes keys{Interpolation::step, true, 4, {0}, {0, 0, 0, 0}};
  EXPECT_EQ(sample(keys, 0.0), (Row{0, 0, 0, 1}));
}

TEST(Keyframes, SplineOfRotations_IsUnit) {
  Keyframes keys{Interpolation::cubic_spline, true, 4, {0, 1}, {}};
  for (const Row& part : {Row{0, 0, 0, 0}, about_z(0.0), Row{0, 0, 3, 0},  //
                          Row{0, 0, 3, 0}, about_z(2.0), Row{0, 0, 0, 0}}) {
    keys.values.insert(keys.values.end(), part.begin(), part.end());
  }
  const Row q = sample(keys, 0.5);
  EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-15);
  // Half way the tangents cancel (h10 = -h11 = 1/8), so it is the mean of both, made unit.
  expect_near(q, about_z(1.0), 1e-15);
}

/// A spline through the values of a cubic polynomial, with its derivatives as tangents, is that
/// polynomial; keys at uneven distances show whether tangents are scaled by the interval.
TEST(Keyframes, SplineWithTheTangentsOfACubic_IsTheCubic) {
  test::Random random(7);
  for (int i = 0; i < test::cases(5000); ++i) {
    std::array<double, 4> c{};
    for (double& number : c) {
      number = random.uniform(-2.0f, 2.0f);
    }
    const auto value = [&](double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); };
    const auto slope = [&](double t) { return c[1] + t * (2 * c[2] + t * 3 * c[3]); };
    Keyframes keys = scalars(Interpolation::cubic_spline, {}, {});
    double time = random.uniform();
    for (int key = 0; key < 4; ++key) {
      keys.times.push_back(time);
      for (const double number : {slope(time), value(time), slope(time)}) {
        keys.values.push_back(number);
      }
      time += random.uniform(0.1f, 2.0f);
    }
    const double s = random.uniform();
    const double at = keys.times.front() + s * (keys.times.back() - keys.times.front());
    ASSERT_NEAR(sample(keys, at)[0], value(at), 1e-10) << "case " << i;
  }
}

/// Against the textbook's formula, sin((1-s)w)/sin w a + sin(sw)/sin w b, where that is well
/// conditioned.
TEST(Keyframes, SlerpOfRandomRotations_IsTheTextbooks) {
  test::Random random(11);
  for (int i = 0; i < test::cases(5000); ++i) {
    std::array<std::array<long double, 4>, 2> q{};
    Keyframes keys{Interpolation::linear, true, 4, {0, 1}, {}};
    for (auto& one : q) {
      long double square = 0.0L;
      for (long double& number : one) {
        number = random.uniform(-1.0f, 1.0f);
        square += number * number;
      }
      for (long double& number : one) {
        number /= std::sqrt(square);
        keys.values.push_back(static_cast<double>(number));
      }
    }
    long double cosine = 0.0L;
    for (std::size_t k = 0; k < 4; ++k) {
      cosine += q[0][k] * q[1][k];
    }
    if (std::abs(cosine) < 1e-3L || std::abs(cosine) > 0.999L) {
      continue;  // two ways of equal length; or too close for the textbook
    }
    const long double sign = cosine < 0.0L ? -1.0L : 1.0L;
    const long double angle = std::acos(sign * cosine);
    const long double s = random.uniform();
    const Row actual = sample(keys, static_cast<double>(s));
    for (std::size_t k = 0; k < 4; ++k) {
      const long double expected =
          (std::sin((1 - s) * angle) * q[0][k] + sign * std::sin(s * angle) * q[1][k]) /
          std::sin(angle);
      ASSERT_NEAR(actual[k], static_cast<double>(expected), 1e-13) << "case " << i;
    }
  }
}

}  // namespace
}  // namespace lume::io::gltf
