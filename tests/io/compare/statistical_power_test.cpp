// SPDX-License-Identifier: Apache-2.0
// Which differences the statistical tests find, and whether they say so truly.
#include "io/compare/statistical_test.h"
#include "tests/io/compare/synthetic_render.h"
#include "tests/support/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lume::io {
namespace {

constexpr test::SyntheticPicture k_picture{96, 72};

/// A tenth of the picture, not aligned with tiles.
bool in_material(int x, int y) { return x >= 20 && x < 52 && y >= 25 && y < 47; }
bool anywhere(int, int) { return true; }

using Where = bool (*)(int x, int y);

/// Relative noise of 5%, with a bias somewhere, and perhaps with fireflies everywhere.
test::Sampler surface(double bias, Where where, double fireflies = 0.0) {
  return [=](test::Noise& noise, int x, int y) {
    const double value = 1.0 + 0.05 * noise.normal();
    const double factor = where(x, y) ? 1.0 + bias : 1.0;
    return value * factor + (fireflies > 0.0 ? noise.bernoulli(fireflies, 1000.0) : 0.0);
  };
}

struct Found {
  int trials = 0;
  int any = 0;
  int tiles = 0;
  int image = 0;
  int without_fireflies = 0;
};

Found count_found(const test::Sampler& biased, const test::Sampler& right,
                  const test::Exposure& actual, const test::Exposure& expected) {
  Found found{std::max(8, test::cases(24))};
  for (int trial = 0; trial < found.trials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(2 * trial);
    const StatisticalResult result =
        test_stacks(test::render_stack(biased, k_picture, actual, seed),
                    test::render_stack(right, k_picture, expected, seed + 1));
    found.any += result.passed ? 0 : 1;
    found.tiles += result.tiles.passed ? 0 : 1;
    found.image += result.image.passed ? 0 : 1;
    found.without_fireflies += result.tiles.without_fireflies ? 1 : 0;
  }
  return found;
}

TEST(StatisticalPower, TwoPercentInOneMaterial_AreFound) {
  for (const auto& [actual, expected] : {std::pair{test::Exposure{8, 1}, test::Exposure{8, 1}},
                                         std::pair{test::Exposure{8, 1}, test::Exposure{16, 2}}}) {
    const Found found =
        count_found(surface(0.02, in_material), surface(0.0, in_material), actual, expected);
    EXPECT_GE(found.tiles, found.trials * 95 / 100);
  }
}

TEST(StatisticalPower, TwoPercentInOneMaterial_AreFoundUnderFireflies) {
  // A firefly in 2000 samples makes the picture half as bright again.
  const Found found = count_found(surface(0.02, in_material, 1.0 / 2000.0),
                                  surface(0.0, in_material, 1.0 / 2000.0), {8, 1}, {8, 1});
  EXPECT_GE(found.tiles, found.trials * 95 / 100);
  EXPECT_GE(found.without_fireflies, found.trials / 2);
}

TEST(StatisticalPower, HalfAPercentOfAll_IsFoundByTheImage) {
  const Found found = count_found(surface(0.005, anywhere), surface(0.0, anywhere), {8, 1}, {8, 1});
  EXPECT_GE(found.image, found.trials * 95 / 100);
}

TEST(StatisticalPower, VariancesOfTheRenderer_FindTwoPercentInOneMaterial) {
  const int trials = std::max(4, test::cases(12));
  int found = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(2 * trial);
    const StatisticalResult result =
        test_moments(test::render_moments(surface(0.02, in_material), k_picture, 16, seed),
                     test::render_moments(surface(0.0, in_material), k_picture, 16, seed + 1));
    if (!result.tiles.passed) ++found;
  }
  EXPECT_GE(found, trials * 95 / 100);
}

/// One tile of the small picture below.
bool in_tile(int x, int y) { return x >= 16 && x < 32 && y < 16; }

struct StatedBias {
  double image = 0.0;
  double tile = 0.0;
};

/// The bias that a pass says it would have seen: the mean of many, as each knows its noise only so
/// well.
StatedBias mean_stated_bias(const test::SyntheticPicture& picture, const test::Exposure& exposure) {
  constexpr int k_passes = 60;
  StatedBias sum;
  for (std::uint64_t pass = 0; pass < k_passes; ++pass) {
    const std::uint64_t seed = 1000 + 2 * pass;
    const StatisticalResult result =
        test_stacks(test::render_stack(surface(0.0, anywhere), picture, exposure, seed),
                    test::render_stack(surface(0.0, anywhere), picture, exposure, seed + 1));
    sum.image += result.image.detectable_bias.value();
    sum.tile += result.tiles.detectable_bias.value();
  }
  return {sum.image / k_passes, sum.tile / k_passes};
}

TEST(StatisticalPower, StatedBias_IsFoundInNineteenOfTwenty) {
  constexpr test::SyntheticPicture k_small{48, 32};
  constexpr test::Exposure k_exposure{10, 1};
  const StatedBias stated = mean_stated_bias(k_small, k_exposure);
  const int trials = test::cases(120);
  const double tolerance = 4.0 * std::sqrt(0.95 * 0.05 / trials);
  int image = 0;
  int tile = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(3 * trial);
    const EstimateStack right =
        test::render_stack(surface(0.0, anywhere), k_small, k_exposure, seed);
    const EstimateStack all =
        test::render_stack(surface(stated.image, anywhere), k_small, k_exposure, seed + 1);
    const EstimateStack part =
        test::render_stack(surface(stated.tile, in_tile), k_small, k_exposure, seed + 2);
    if (!test_stacks(all, right).image.passed) ++image;
    if (!test_stacks(part, right).tiles.passed) ++tile;
  }
  EXPECT_NEAR(static_cast<double>(image) / trials, 0.95, tolerance);
  EXPECT_NEAR(static_cast<double>(tile) / trials, 0.95, tolerance);
}

}  // namespace
}  // namespace lume::io
