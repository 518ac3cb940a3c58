// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/polynomial.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lume::geometry {
namespace {

using test::Random;

/// The coefficients of leading * product of (t - root), in long double.
template <std::size_t size>
std::array<double, size> expand(const std::vector<double>& roots, double leading) {
  std::array<long double, size> c{};
  c[0] = leading;
  for (std::size_t n = 0; n < roots.size(); ++n) {
    for (std::size_t i = n + 1; i > 0; --i) c[i] = c[i - 1] - roots[n] * c[i];
    c[0] *= -static_cast<long double>(roots[n]);
  }
  std::array<double, size> result{};
  for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<double>(c[i]);
  return result;
}

void expect_roots(const RealRoots& found, std::vector<double> expected, double tolerance) {
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.count, expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_NEAR(found.t[i], expected[i], tolerance) << "root " << i;
  }
}

TEST(Polynomial, RandomSeparateRoots_AreAllFoundInOrder) {
  Random random(1);
  for (int i = 0; i < 50000; ++i) {
    std::vector<double> roots;
    const std::size_t count = 3 + random.below(2);
    while (roots.size() < count) {
      const double root = random.uniform(-1.0f, 1.0f);
      const auto is_near = [root](double other) { return std::abs(root - other) < 1e-3; };
      if (std::none_of(roots.begin(), roots.end(), is_near)) roots.push_back(root);
    }
    const double leading = random.uniform(0.5f, 2.0f) * (random.below(2) == 0 ? 1.0 : -1.0);
    const RealRoots found = count == 3 ? cubic_roots(expand<4>(roots, leading), -2.0, 2.0)
                                       : quartic_roots(expand<5>(roots, leading), -2.0, 2.0);
    // Coefficients' rounding (about 1e-16) over the product of distances to the other roots.
    ASSERT_NO_FATAL_FAILURE(expect_roots(found, roots, 1e-5)) << "case " << i;
    const double lower = random.uniform(-1.0f, 1.0f);
    const double upper = random.uniform(-1.0f, 1.0f);
    if (lower > upper) continue;
    const RealRoots some = count == 3 ? cubic_roots(expand<4>(roots, leading), lower, upper)
                                      : quartic_roots(expand<5>(roots, leading), lower, upper);
    std::vector<double> inside;
    for (const double root : found) {
      if (root >= lower && root <= upper) inside.push_back(root);
    }
    ASSERT_NO_FATAL_FAILURE(expect_roots(some, inside, 1e-5)) << "case " << i;
  }
}

TEST(Polynomial, RandomCoefficients_SignChangesOfADenseScanAreFound) {
  Random random(2);
  int scanned = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<double, 5> c{};
    for (double& value : c) value = random.uniform(-1.0f, 1.0f);
    const RealRoots found = quartic_roots(c, -3.0, 3.0);
    const auto value = [&c](long double t) {
      return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * static_cast<long double>(c[4]))));
    };
    for (const double t : found) {
      ASSERT_LT(std::abs(static_cast<double>(value(t))), 1e-13 * std::max(1.0, std::pow(t, 4)));
    }
    constexpr int k_steps = 300;
    for (int k = 0; k < k_steps; ++k) {
      const double a = -3.0 + 6.0 * k / k_steps;
      const double b = -3.0 + 6.0 * (k + 1) / k_steps;
      if ((value(a) < 0) == (value(b) < 0)) continue;
      ++scanned;
      const auto is_between = [=](double t) { return t >= a - 1e-12 && t <= b + 1e-12; };
      ASSERT_TRUE(std::any_of(found.begin(), found.end(), is_between)) << "case " << i;
    }
  }
  EXPECT_GT(scanned, 2000);
}

TEST(Polynomial, VanishingLeadingCoefficients_LeaveTheRootsOfTheRest) {
  expect_roots(quartic_roots({-6.0, 11.0, -6.0, 1.0, 0.0}, 0.0, 10.0), {1.0, 2.0, 3.0}, 1e-12);
  expect_roots(quartic_roots({2.0, -3.0, 1.0, 0.0, 0.0}, 0.0, 10.0), {1.0, 2.0}, 1e-12);
  expect_roots(quartic_roots({-3.0, 2.0, 0.0, 0.0, 0.0}, 0.0, 10.0), {1.5}, 1e-12);
  expect_roots(quartic_roots({-3.0, 0.0, 0.0, 0.0, 0.0}, 0.0, 10.0), {}, 0.0);
  expect_roots(quartic_roots({0.0, 0.0, 0.0, 0.0, 0.0}, 0.0, 10.0), {}, 0.0);
  expect_roots(quartic_roots({2.0, -3.0, 1.0, 1e-300, 1e-300}, 0.0, 10.0), {1.0, 2.0}, 1e-12);
  expect_roots(cubic_roots({-2.0, 1.0, 0.0, 0.0}, -5.0, 5.0), {2.0}, 1e-12);
}

TEST(Polynomial, MultipleRoots_AreFound) {
  // (t^2 - 1)^2, (t - 1)^2 (t + 2), t^4, (t - 1/4)^3
  expect_roots(quartic_roots({1.0, 0.0, -2.0, 0.0, 1.0}, -2.0, 2.0), {-1.0, 1.0}, 1e-7);
  expect_roots(cubic_roots({2.0, -3.0, 0.0, 1.0}, -3.0, 2.0), {-2.0, 1.0}, 1e-7);
  expect_roots(quartic_roots({0.0, 0.0, 0.0, 0.0, 1.0}, -1.0, 2.0), {0.0}, 1e-7);
  expect_roots(cubic_roots({-1.0 / 64, 3.0 / 16, -0.75, 1.0}, -1.0, 1.0), {0.25}, 1e-4);
}

TEST(Polynomial, RootAtAnEndOfTheInterval_Counts) {
  expect_roots(cubic_roots({-6.0, 11.0, -6.0, 1.0}, 1.0, 2.0), {1.0, 2.0}, 1e-12);
  expect_roots(cubic_roots({-6.0, 11.0, -6.0, 1.0}, 1.5, 1.75), {}, 0.0);
}

TEST(Polynomial, NotANumber_HasNoRoots) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < 5; ++i) {
    std::array<double, 5> c{1.0, -3.0, 1.0, 1.0, 1.0};
    c[i] = nan;
    EXPECT_EQ(quartic_roots(c, -1.0, 1.0).count, 0U);
  }
}

}  // namespace
}  // namespace lume::geometry
