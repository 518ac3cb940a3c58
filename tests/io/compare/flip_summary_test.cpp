// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_summary.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace lume::io {
namespace {

TEST(FlipSummary, NoErrors_Zero) {
  for (const std::vector<float>& errors : {std::vector<float>{}, std::vector<float>(9, 0.0f)}) {
    const FlipSummary summary = summarize_flip(errors);
    EXPECT_EQ(summary.mean, 0.0);
    EXPECT_EQ(summary.weighted_median, 0.0);
    EXPECT_EQ(summary.max, 0.0);
  }
}

TEST(FlipSummary, EqualErrors_AllTheSame) {
  const FlipSummary summary = summarize_flip(std::vector<float>(10, 0.25f));
  for (const double value : {summary.mean, summary.first_weighted_quartile, summary.weighted_median,
                             summary.third_weighted_quartile, summary.min, summary.max}) {
    EXPECT_EQ(value, 0.25);
  }
}

// Of a total of 2: 0.125 + 0.125 + 0.25 + 0.5 + 1.
TEST(FlipSummary, FewErrors_QuantilesByWeight) {
  const std::vector<float> errors = {0.0f, 1.0f, 0.125f, 0.0f, 0.5f, 0.25f, 0.125f, 0.0f};
  const FlipSummary summary = summarize_flip(errors);
  EXPECT_DOUBLE_EQ(summary.mean, 0.25);
  EXPECT_EQ(summary.first_weighted_quartile, 0.25);
  EXPECT_EQ(summary.weighted_median, 0.5);
  EXPECT_EQ(summary.third_weighted_quartile, 1.0);
  EXPECT_EQ(summary.min, 0.0);
  EXPECT_EQ(summary.max, 1.0);
}

// Errors spread evenly over [0, 1] have a weight of e^2 below e.
TEST(FlipSummary, EvenlySpread_RootsOfTheShares) {
  test::Random random(1);
  std::vector<float> errors(200000);
  for (float& error : errors) error = random.uniform();
  const FlipSummary summary = summarize_flip(errors);
  EXPECT_NEAR(summary.mean, 0.5, 0.003);
  EXPECT_NEAR(summary.first_weighted_quartile, 0.5, 0.003);
  EXPECT_NEAR(summary.weighted_median, 0.70711, 0.003);
  EXPECT_NEAR(summary.third_weighted_quartile, 0.86603, 0.003);

  std::shuffle(errors.begin(), errors.end(), std::mt19937(2));
  const FlipSummary shuffled = summarize_flip(errors);
  EXPECT_EQ(shuffled.mean, summary.mean);
  EXPECT_EQ(shuffled.weighted_median, summary.weighted_median);
}

}  // namespace
}  // namespace lume::io
