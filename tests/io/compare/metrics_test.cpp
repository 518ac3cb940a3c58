// SPDX-License-Identifier: Apache-2.0
#include "io/compare/metrics.h"

#include "geometry/parallel.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lume::io {
namespace {

using Plane = std::vector<float>;

PixelMetrics measure_one(const Plane& actual, const Plane& expected) {
  const Plane* a = &actual;
  const Plane* e = &expected;
  return measure({&a, 1}, {&e, 1});
}

TEST(PixelMetrics, EqualValues_AreNoDistanceAway) {
  const Plane values = {0.0f, -3.0f, 1e30f, 0.25f};
  const PixelMetrics metrics = measure_one(values, values);
  EXPECT_EQ(metrics.max, 0.0);
  EXPECT_EQ(metrics.rmse, 0.0);
  EXPECT_EQ(metrics.outliers, 0.0);
  EXPECT_EQ(metrics.psnr, std::numeric_limits<double>::infinity());
}

TEST(PixelMetrics, ConstantOffset_HasClosedForms) {
  const Plane expected(1000, 0.5f);
  const Plane actual(1000, 0.75f);
  const PixelMetrics metrics = measure_one(actual, expected);
  EXPECT_DOUBLE_EQ(metrics.max, 0.25);
  EXPECT_DOUBLE_EQ(metrics.mae, 0.25);
  EXPECT_DOUBLE_EQ(metrics.rmse, 0.25);
  EXPECT_NEAR(metrics.relmse, 0.0625 / 0.26, 1e-13);  // the only sum here that is rounded
  EXPECT_DOUBLE_EQ(metrics.psnr, 20.0 * std::log10(4.0));
  EXPECT_DOUBLE_EQ(metrics.outliers, 1.0);
}

TEST(PixelMetrics, Outliers_AreThoseBeyondOneFiveHundredth) {
  const Plane expected = {1.0f, 1.0f, 0.0f, 0.0f, -2.0f};
  const Plane actual = {1.00199f, 1.00201f, 1.99e-5f, 2.01e-5f, -2.00399f};
  EXPECT_DOUBLE_EQ(measure_one(actual, expected).outliers, 0.4);
}

// Within a plane, from one plane to the next, and where sums are taken in parts.
TEST(PixelMetrics, EqualDifferences_TheFirstIsTheWorst) {
  const std::size_t length = 200000;
  const std::vector<Plane> expected(3, Plane(length, 1.0f));
  std::vector<Plane> actual = expected;
  actual[1][150000] = 3.0f;
  actual[1][150001] = -1.0f;
  actual[1][length - 1] = 3.0f;
  actual[2][0] = 3.0f;
  std::vector<const Plane*> a;
  std::vector<const Plane*> e;
  for (std::size_t p = 0; p < actual.size(); ++p) {
    a.push_back(&actual[p]);
    e.push_back(&expected[p]);
  }
  const PixelMetrics metrics = measure(a, e);
  EXPECT_EQ(metrics.max, 2.0);
  EXPECT_EQ(metrics.worst_plane, 1u);
  EXPECT_EQ(metrics.worst_index, 150000u);
}

/// The formulas in extended precision, one value after the other.
struct Plain {
  long double mae = 0;
  long double mse = 0;
  long double relmse = 0;
  long double max = 0;
  std::size_t plane = 0;
  std::size_t index = 0;
};

Plain plain(const std::vector<Plane>& actual, const std::vector<Plane>& expected) {
  Plain result;
  long double count = 0;
  for (std::size_t p = 0; p < actual.size(); ++p) {
    for (std::size_t i = 0; i < actual[p].size(); ++i) {
      const long double e = expected[p][i];
      const long double d = std::fabs(actual[p][i] - e);
      result.mae += d;
      result.mse += d * d;
      result.relmse += d * d / (e * e + 0.01L);
      count += 1;
      if (d > result.max) {
        result.max = d;
        result.plane = p;
        result.index = i;
      }
    }
  }
  result.mae /= count;
  result.mse /= count;
  result.relmse /= count;
  return result;
}

TEST(PixelMetrics, RandomPlanes_AgreeWithExtendedPrecisionForAnyThreads) {
  test::Random random(3);
  for (int round = 0; round < 20; ++round) {
    const std::size_t length = 1 + random.below(200000);
    std::vector<Plane> actual(1 + random.below(4), Plane(length));
    std::vector<Plane> expected(actual.size(), Plane(length));
    std::vector<const Plane*> a;
    std::vector<const Plane*> e;
    for (std::size_t p = 0; p < actual.size(); ++p) {
      for (float& value : actual[p]) value = random.uniform(-2.0f, 2.0f);
      for (float& value : expected[p]) value = random.uniform(-2.0f, 2.0f);
      a.push_back(&actual[p]);
      e.push_back(&expected[p]);
    }
    const PixelMetrics metrics = measure(a, e);
    const Plain oracle = plain(actual, expected);
    EXPECT_EQ(metrics.max, static_cast<double>(oracle.max));
    EXPECT_EQ(metrics.worst_plane, oracle.plane);
    EXPECT_EQ(metrics.worst_index, oracle.index);
    EXPECT_NEAR(metrics.mae, static_cast<double>(oracle.mae), 1e-12);
    EXPECT_NEAR(metrics.rmse, static_cast<double>(std::sqrt(oracle.mse)), 1e-12);
    EXPECT_NEAR(metrics.relmse / static_cast<double>(oracle.relmse), 1.0, 1e-11);
    const geometry::ThreadLimit one(1);
    EXPECT_EQ(measure(a, e).rmse, metrics.rmse);
    EXPECT_EQ(measure(a, e).relmse, metrics.relmse);
  }
}

}  // namespace
}  // namespace lume::io
