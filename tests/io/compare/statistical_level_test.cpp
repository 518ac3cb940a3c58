// SPDX-License-Identifier: Apache-2.0
// How often the statistical tests fail pictures of equal expectation, over many seeded trials.
#include "io/compare/statistical_test.h"
#include "tests/io/compare/synthetic_render.h"
#include "tests/support/cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lume::io {
namespace {

constexpr test::SyntheticPicture k_picture{36, 16};
constexpr StatisticalSettings k_settings{.significance = 0.01, .tile_size = 8};

/// The most failures of `trials` that a rate of `level` explains with a probability of 99.9%.
int binomial_bound(int trials, double level) {
  double term = std::pow(1.0 - level, trials);
  double sum = term;
  int count = 0;
  while (sum < 0.999) {
    term *= level / (1.0 - level) * (trials - count) / (count + 1.0);
    sum += term;
    ++count;
  }
  return count;
}

struct Exposures {
  test::Exposure actual;
  test::Exposure expected;
};

int failures_of_stacks(const test::Sampler& sampler, const Exposures& exposures, int trials) {
  int failures = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(2 * trial);
    const EstimateStack actual = test::render_stack(sampler, k_picture, exposures.actual, seed);
    const EstimateStack expected =
        test::render_stack(sampler, k_picture, exposures.expected, seed + 1);
    if (!test_stacks(actual, expected, k_settings).passed) ++failures;
  }
  return failures;
}

/// Each of the exposures by itself, and all together.
template <std::size_t N>
void expect_level(const test::Sampler& sampler, const std::array<Exposures, N>& all) {
  const int trials = test::cases(200);
  int failures = 0;
  for (const Exposures& exposures : all) {
    const int count = failures_of_stacks(sampler, exposures, trials);
    EXPECT_LE(count, binomial_bound(trials, k_settings.significance))
        << exposures.actual.images << " images of " << exposures.actual.samples << " samples, "
        << exposures.expected.images << " of " << exposures.expected.samples;
    failures += count;
  }
  const int all_trials = trials * static_cast<int>(N);
  EXPECT_LE(failures, binomial_bound(all_trials, k_settings.significance));
  ::testing::Test::RecordProperty("failures", failures);
  ::testing::Test::RecordProperty("trials", all_trials);
}

constexpr std::array k_usual = {Exposures{{8, 1}, {8, 1}}, Exposures{{8, 1}, {32, 1}},
                                Exposures{{8, 1}, {8, 4}}, Exposures{{8, 4}, {16, 1}}};

TEST(StatisticalLevel, GaussianPixels_HoldIt) { expect_level(test::gaussian_sample, k_usual); }
TEST(StatisticalLevel, ExponentialPixels_HoldIt) {
  expect_level(test::exponential_sample, k_usual);
}
TEST(StatisticalLevel, LognormalPixels_HoldIt) { expect_level(test::lognormal_sample, k_usual); }
TEST(StatisticalLevel, SmallHoles_HoldIt) { expect_level(test::hole_sample, k_usual); }
TEST(StatisticalLevel, Fireflies_HoldIt) { expect_level(test::firefly_sample, k_usual); }
TEST(StatisticalLevel, MixedTextures_HoldIt) { expect_level(test::texture_sample, k_usual); }

TEST(StatisticalLevel, MissedLight_IsNoDifference) {
  // A side of few samples that misses the light everywhere knows nothing of its variance.
  constexpr std::array k_uneven = {Exposures{{8, 1}, {32, 4}}};
  expect_level(test::firefly_sample, k_uneven);
  expect_level(test::texture_sample, k_uneven);
}

TEST(StatisticalLevel, FewImages_HoldItWithoutExchange) {
  // Sums of hits and misses repeat themselves: tiles and pixels agree by chance.
  constexpr std::array k_few = {Exposures{{2, 4}, {2, 4}}, Exposures{{4, 1}, {4, 1}}};
  expect_level(test::texture_sample, k_few);
  expect_level(test::hole_sample, std::array{k_few.front()});
}

TEST(StatisticalLevel, TwoImagesAgainstMany_HoldItByExchange) {
  // Both find the light, or neither: by itself, Welch's test takes that for knowledge.
  expect_level(test::hole_sample, std::array{Exposures{{2, 4}, {32, 4}}});
}

TEST(StatisticalLevel, VariancesOfTheRenderer_HoldIt) {
  const int trials = test::cases(60);
  for (const auto& sampler :
       {test::exponential_sample, test::firefly_sample, test::texture_sample}) {
    for (const auto& [actual, expected] : {std::pair{16, 16}, std::pair{16, 64}}) {
      int failures = 0;
      for (int trial = 0; trial < trials; ++trial) {
        const auto seed = static_cast<std::uint64_t>(2 * trial);
        const auto result =
            test_moments(test::render_moments(sampler, k_picture, actual, seed),
                         test::render_moments(sampler, k_picture, expected, seed + 1), k_settings);
        if (!result.passed) ++failures;
      }
      EXPECT_LE(failures, binomial_bound(trials, k_settings.significance));
    }
  }
}

TEST(StatisticalLevel, GaussianImageMeans_HaveUniformP) {
  constexpr test::SyntheticPicture k_small{6, 6};
  const int trials = test::cases(2000);
  for (const Exposures& exposures : {Exposures{{8, 1}, {8, 1}}, Exposures{{5, 1}, {12, 4}}}) {
    std::array<int, 10> counts{};
    for (int trial = 0; trial < trials; ++trial) {
      const auto seed = static_cast<std::uint64_t>(2 * trial);
      const StatisticalResult result = test_stacks(
          test::render_stack(test::gaussian_sample, k_small, exposures.actual, seed),
          test::render_stack(test::gaussian_sample, k_small, exposures.expected, seed + 1));
      const auto decile = static_cast<std::size_t>(result.image.smallest_p() * 10.0);
      ++counts[std::min<std::size_t>(decile, 9)];
    }
    // The guard against skew moves a few from small to large p where images are not as many.
    const double expected = trials / 10.0;
    const double sigma = std::sqrt(expected * 0.9);
    EXPECT_LT(counts.front(), expected + 4.0 * sigma);
    EXPECT_GT(counts.front(), 0.6 * expected - 4.0 * sigma);
    if (exposures.actual.images != exposures.expected.images) continue;
    for (const int count : counts) EXPECT_NEAR(count, expected, 4.0 * sigma);
  }
}

}  // namespace
}  // namespace lume::io
