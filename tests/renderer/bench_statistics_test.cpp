// SPDX-License-Identifier: Apache-2.0
// Medians and their intervals against published tables and against simulation, and the choice of a
// hit rate.
#include "renderer/bench/hit_rate.h"
#include "renderer/bench/statistics.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::renderer {
namespace {

TEST(BenchStatistics, Median_IsTheMiddle) {
  EXPECT_EQ(median({}), 0.0);
  EXPECT_EQ(median({7.0}), 7.0);
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
}

/// The binomial sum by its definition, with exact factorials.
double confidence_by_definition(std::size_t trimmed, std::size_t n) {
  double outside = 0.0;
  for (std::size_t k = 0; k <= trimmed; ++k) {
    const auto real = [](std::size_t i) { return static_cast<double>(i); };
    outside += std::exp(std::lgamma(real(n) + 1.0) - std::lgamma(real(k) + 1.0) -
                        std::lgamma(real(n - k) + 1.0) - real(n) * std::log(2.0));
  }
  return 1.0 - 2.0 * outside;
}

TEST(BenchStatistics, Interval_TrimsAsTheTableOfTheBinomialSays) {
  // Numbers of the sign test's table for 95%, two-sided: as many values as may be left out.
  EXPECT_EQ(trimmed_at_ends(5), 0u);
  EXPECT_EQ(trimmed_at_ends(6), 0u);
  EXPECT_EQ(trimmed_at_ends(8), 0u);
  EXPECT_EQ(trimmed_at_ends(9), 1u);
  EXPECT_EQ(trimmed_at_ends(11), 1u);
  EXPECT_EQ(trimmed_at_ends(12), 2u);
  EXPECT_EQ(trimmed_at_ends(20), 5u);
  EXPECT_EQ(trimmed_at_ends(30), 9u);
  for (std::size_t n = 1; n < 200; ++n) {
    const std::size_t trimmed = trimmed_at_ends(n);
    EXPECT_NEAR(confidence_of(n), confidence_by_definition(trimmed, n), 1e-9) << n;
    if (n >= 6) {
      EXPECT_GE(confidence_of(n), 0.95) << n;
      EXPECT_LT(confidence_by_definition(trimmed + 1, n), 0.95) << n;
    }
  }
}

TEST(BenchStatistics, Estimate_OfKnownValues) {
  const Estimate estimate = estimate_median({9, 1, 8, 2, 7, 3, 6, 4, 5});
  EXPECT_EQ(estimate.median, 5.0);
  EXPECT_EQ(estimate.low, 2.0);
  EXPECT_EQ(estimate.high, 8.0);
  EXPECT_EQ(estimate_median({}).high, 0.0);
}

TEST(BenchStatistics, Interval_HoldsTheMedianAsOftenAsItClaims) {
  // Skewed like times: an exponential distribution, whose median is ln 2.
  test::Random random(1);
  constexpr int k_trials = 20000;
  int inside = 0;
  for (int i = 0; i < k_trials; ++i) {
    std::vector<double> values;
    for (int k = 0; k < 9; ++k) values.push_back(-std::log(1.0 - random.uniform()));
    const Estimate estimate = estimate_median(values);
    if (estimate.low <= std::log(2.0) && std::log(2.0) <= estimate.high) ++inside;
  }
  const double expected = confidence_of(9);
  const double deviation = std::sqrt(expected * (1.0 - expected) / k_trials);
  EXPECT_NEAR(static_cast<double>(inside) / k_trials, expected, 5.0 * deviation);
}

TEST(HitRate, Counts_AreTheMostThatThereAre) {
  const auto half = counts_for_hit_rate({600, 200}, 0.5);
  ASSERT_TRUE(half);
  EXPECT_EQ(half->hits, 200u);
  EXPECT_EQ(half->misses, 200u);
  const auto all = counts_for_hit_rate({600, 200}, 1.0);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->hits, 600u);
  EXPECT_EQ(all->misses, 0u);
  EXPECT_EQ(counts_for_hit_rate({600, 200}, 0.0)->misses, 200u);
  EXPECT_FALSE(counts_for_hit_rate({600, 0}, 0.5));
  EXPECT_FALSE(counts_for_hit_rate({0, 600}, 1.0));
  EXPECT_FALSE(counts_for_hit_rate({0, 0}, 0.5));
}

TEST(HitRate, Counts_KeepTheShareAndTheLimits) {
  test::Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const HitCounts recorded{random.below(1000), random.below(1000)};
    const double share = random.uniform();
    const auto counts = counts_for_hit_rate(recorded, share);
    if (!counts) continue;
    EXPECT_LE(counts->hits, recorded.hits);
    EXPECT_LE(counts->misses, recorded.misses);
    const auto total = static_cast<double>(counts->total());
    EXPECT_NEAR(static_cast<double>(counts->hits), share * total, 1.0);
    // One more of the kind that there is too little of would not be there.
    const bool exhausted = static_cast<double>(recorded.hits) < share * (total + 1.0) ||
                           static_cast<double>(recorded.misses) < (1.0 - share) * (total + 1.0);
    EXPECT_TRUE(exhausted) << recorded.hits << " " << recorded.misses << " " << share;
  }
}

}  // namespace
}  // namespace lume::renderer
