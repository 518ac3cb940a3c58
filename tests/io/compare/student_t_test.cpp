// SPDX-License-Identifier: Apache-2.0
#include "io/compare/student_t.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace lume::io {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

double two_sided_p(double t, double degrees) {
  return std::exp(student_two_sided_log_p(t, degrees));
}

/// P(|T| >= t) by Simpson's rule over the density from 0 to t; for t where that does not cancel.
double integrated_p(double t, double degrees) {
  constexpr int k_steps = 2000;
  const double front = std::exp(std::lgamma(0.5 * (degrees + 1.0)) - std::lgamma(0.5 * degrees)) /
                       std::sqrt(degrees * std::numbers::pi);
  double sum = 0.0;
  for (int i = 0; i <= k_steps; ++i) {
    const double x = t * i / k_steps;
    const double density = front * std::pow(1.0 + x * x / degrees, -0.5 * (degrees + 1.0));
    const double ends = i == 0 || i == k_steps ? 1.0 : i % 2 == 0 ? 2.0 : 4.0;
    sum += ends * density;
  }
  return 1.0 - 2.0 * sum * t / k_steps / 3.0;
}

TEST(StudentT, OneTwoAndFourDegrees_AreClosedForms) {
  for (const double t : {1e-3, 0.1, 0.5, 1.0, 1.7, 1.8, 3.0, 7.0, 40.0}) {
    EXPECT_NEAR(two_sided_p(t, 1.0), 2.0 / std::numbers::pi * std::atan(1.0 / t), 1e-13);
    EXPECT_NEAR(two_sided_p(t, 2.0), 1.0 - t / std::sqrt(2.0 + t * t), 1e-13);
    const double s = t / std::sqrt(1.0 + t * t / 4.0);
    EXPECT_NEAR(two_sided_p(t, 4.0), 1.0 - 0.75 * s * (1.0 - s * s / 12.0), 1e-13);
  }
}

TEST(StudentT, InfiniteDegrees_AreNormal) {
  for (const double z : {0.0, 0.3, 1.0, 1.959963984540054, 5.0, 20.0}) {
    EXPECT_EQ(student_two_sided_log_p(z, k_infinity), normal_two_sided_log_p(z));
    EXPECT_NEAR(std::exp(normal_two_sided_log_p(z)), std::erfc(z / std::numbers::sqrt2), 1e-15);
  }
  EXPECT_NEAR(std::exp(normal_two_sided_log_p(1.959963984540054)), 0.05, 1e-14);
}

TEST(StudentT, RealDegrees_AreTheIntegralOfTheDensity) {
  test::Random random(1);
  for (int i = 0; i < 300; ++i) {
    const auto t = static_cast<double>(random.uniform(0.01f, 4.0f));
    const double degrees = std::exp(static_cast<double>(random.uniform(0.0f, 8.0f)));
    EXPECT_NEAR(two_sided_p(t, degrees), integrated_p(t, degrees), 1e-9) << t << " " << degrees;
  }
}

TEST(StudentT, FarTail_IsItsPowerLaw) {
  // For large t the density is front * (t^2 / 3)^-2 with 3 degrees of freedom; front is
  // 2 / (pi sqrt 3). The integral over both tails is 4 sqrt(3) / (pi t^3).
  for (const double t : {1e6, 1e100, 1e200}) {
    const double expected = std::log(4.0 * std::numbers::sqrt3 / std::numbers::pi);
    EXPECT_NEAR(student_two_sided_log_p(t, 3.0), expected - 3.0 * std::log(t), 1e-9) << t;
  }
  EXPECT_EQ(student_two_sided_log_p(k_infinity, 3.0), -k_infinity);
}

TEST(StudentT, FarNormalTail_LiesBetweenItsBounds) {
  // Mills' ratio: z / (1 + z^2) < P(Z > z) / density(z) < 1 / z (Gordon 1941). At z = 20 sqrt 2 the
  // computation changes from erfc to its expansion.
  for (const double z : {10.0, 28.28, 28.29, 100.0, 1e8}) {
    const double log_density = -0.5 * z * z - 0.5 * std::log(2.0 * std::numbers::pi);
    const double log_ratio = normal_two_sided_log_p(z) - std::numbers::ln2 - log_density;
    const double rounding = 1e-15 * z * z;
    EXPECT_LT(log_ratio, -std::log(z) + rounding);
    EXPECT_GT(log_ratio, std::log(z / (1.0 + z * z)) - rounding);
  }
  const double step = normal_two_sided_log_p(28.2843) - normal_two_sided_log_p(28.2842);
  EXPECT_NEAR(step, -28.2842 * 1e-4 - std::log(28.2843 / 28.2842), 1e-7);
}

TEST(StudentT, ManyDegrees_ApproachTheNormalDistribution) {
  // The first term of the difference is z^4 / (4 degrees) (Abramowitz and Stegun 1964, 26.7.8).
  for (const double degrees : {1e5, 1e6, 1e7, 1e8}) {
    for (const double z : {1.0, 5.0, 8.0}) {
      EXPECT_NEAR(student_two_sided_log_p(z, degrees), normal_two_sided_log_p(z),
                  0.5 * (z + z * z * z * z) / degrees);
    }
  }
}

TEST(StudentT, FewerDegrees_HaveHeavierTails) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const auto t = static_cast<double>(random.uniform(0.01f, 50.0f));
    const double degrees = std::exp(static_cast<double>(random.uniform(0.0f, 10.0f)));
    EXPECT_GT(student_two_sided_log_p(t, degrees), student_two_sided_log_p(t, degrees * 1.1));
    EXPECT_EQ(student_two_sided_log_p(t, degrees), student_two_sided_log_p(-t, degrees));
  }
}

TEST(StudentT, Critical_IsTheInverse) {
  EXPECT_NEAR(student_critical(std::log(0.05), 10.0), 2.2281388519862744, 1e-12);
  EXPECT_NEAR(student_critical(std::log(0.01), k_infinity), 2.5758293035489, 1e-12);
  EXPECT_EQ(student_critical(0.0, 5.0), 0.0);
  EXPECT_EQ(student_critical(-k_infinity, 5.0), k_infinity);
  test::Random random(3);
  for (int i = 0; i < 500; ++i) {
    const double log_p = -std::exp(static_cast<double>(random.uniform(-8.0f, 6.0f)));
    const double degrees = std::exp(static_cast<double>(random.uniform(0.0f, 12.0f)));
    const double t = student_critical(log_p, degrees);
    EXPECT_NEAR(student_two_sided_log_p(t, degrees) / log_p, 1.0, 1e-10) << log_p << " " << degrees;
  }
}

}  // namespace
}  // namespace lume::io
