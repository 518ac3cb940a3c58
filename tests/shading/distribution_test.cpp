// SPDX-License-Identifier: Apache-2.0
#include "shading/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lume::shading {
namespace {

using geometry::Vec2;

constexpr float k_below_one = 0x1.fffffep-1f;

std::vector<float> random_weights(std::size_t count, std::mt19937& random) {
  std::vector<float> weights(count);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (float& weight : weights) weight = uniform(random) < 0.3f ? 0.0f : uniform(random);
  weights[count / 2] = 1.0f;
  return weights;
}

/// z for a chi-squared statistic (Wilson and Hilferty 1931): standard normal if the hypothesis
/// holds.
double wilson_hilferty(double chi_squared, double degrees) {
  const double spread = 2.0 / (9.0 * degrees);
  return (std::cbrt(chi_squared / degrees) - (1.0 - spread)) / std::sqrt(spread);
}

double chi_squared(const std::vector<int>& counts, const std::vector<double>& probabilities,
                   int total) {
  double sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (probabilities[i] == 0.0) {
      EXPECT_EQ(counts[i], 0) << "cell " << i << " has no probability";
      continue;
    }
    const double expected = probabilities[i] * total;
    sum += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  return sum;
}

TEST(Distribution1D, EveryRandomNumber_ReachesACellWithProbability) {
  const std::vector<float> weights{0.0f, 0.0f, 2.0f, 0.0f, 6.0f, 0.0f, 0.0f};
  const Distribution1D distribution(weights);
  EXPECT_EQ(distribution.sample(0.0f).cell, 2u);
  EXPECT_EQ(distribution.sample(std::nextafter(0.25f, 0.0f)).cell, 2u);
  EXPECT_EQ(distribution.sample(0.25f).cell, 4u);
  EXPECT_EQ(distribution.sample(k_below_one).cell, 4u);
  EXPECT_EQ(distribution.sample(1.0f).cell, 4u) << "1 is not in [0, 1) but must not break anything";
  EXPECT_EQ(distribution.sample(std::nanf("")).cell, 2u);
  EXPECT_FLOAT_EQ(distribution.probability(2), 0.25f);
  EXPECT_FLOAT_EQ(distribution.probability(4), 0.75f);
  EXPECT_EQ(distribution.probability(6), 0.0f);
  EXPECT_DOUBLE_EQ(distribution.total(), 8.0);
}

TEST(Distribution1D, AllZeroWeights_CountAsEqual) {
  const Distribution1D distribution(std::vector<float>(4, 0.0f));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(distribution.probability(i), 0.25f);
    EXPECT_EQ(distribution.sample(0.25f * static_cast<float>(i)).cell, i);
  }
  EXPECT_EQ(distribution.total(), 0.0);
}

TEST(Distribution1D, NegativeAndNonFiniteWeights_CountAsZero) {
  const std::vector<float> weights{-1.0f, INFINITY, 1.0f, std::nanf("")};
  const Distribution1D distribution(weights);
  EXPECT_EQ(distribution.probability(2), 1.0f);
  EXPECT_EQ(distribution.sample(0.5f).cell, 2u);
}

TEST(Distribution1D, RandomWeights_SampleLiesInItsCell) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (const std::size_t size : {1u, 2u, 7u, 49u, 1000u, 16384u}) {
    const std::vector<float> weights = random_weights(size, random);
    const Distribution1D distribution(weights);
    for (int i = 0; i < 3000; ++i) {
      const auto sample = distribution.sample(uniform(random));
      ASSERT_GT(weights[sample.cell], 0.0f);
      ASSERT_EQ(sample.probability, distribution.probability(sample.cell));
      ASSERT_LT(sample.position, 1.0f);
      ASSERT_EQ(static_cast<std::size_t>(sample.position * static_cast<float>(size)), sample.cell);
    }
  }
}

TEST(Distribution1D, ManySamples_PassChiSquared) {
  std::mt19937 random(17);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  const std::vector<float> weights = random_weights(50, random);
  double total = 0.0;
  for (const float weight : weights) total += weight;
  std::vector<double> probabilities;
  int cells = 0;
  for (const float weight : weights) {
    probabilities.push_back(weight / total);
    cells += weight > 0.0f ? 1 : 0;
  }
  constexpr int k_samples = 200000;
  std::vector<int> counts(weights.size());
  const Distribution1D distribution(weights);
  for (int i = 0; i < k_samples; ++i) ++counts[distribution.sample(uniform(random)).cell];
  EXPECT_LT(std::abs(wilson_hilferty(chi_squared(counts, probabilities, k_samples), cells - 1)),
            4.0);
}

TEST(Distribution1D, PositionWithinACell_IsUniform) {
  const std::vector<float> weights{1.0f, 3.0f};
  const Distribution1D distribution(weights);
  for (int i = 0; i < 1000; ++i) {
    // The inverse of the piecewise linear cumulative sum, in closed form.
    const float r = static_cast<float>(i) / 1000.0f;
    const float expected = r < 0.25f ? 2.0f * r : 0.5f + (r - 0.25f) / 1.5f;
    EXPECT_NEAR(distribution.sample(r).position, expected, 1e-6f);
  }
}

TEST(Distribution2D, ManySamples_PassChiSquared) {
  constexpr int k_width = 9;
  constexpr int k_height = 7;
  constexpr int k_samples = 300000;
  std::mt19937 random(23);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<float> weights = random_weights(k_width * k_height, random);
  for (int x = 0; x < k_width; ++x) weights[static_cast<std::size_t>(2 * k_width + x)] = 0.0f;
  double total = 0.0;
  for (const float weight : weights) total += weight;
  std::vector<double> probabilities;
  int cells = 0;
  for (const float weight : weights) {
    probabilities.push_back(weight / total);
    cells += weight > 0.0f ? 1 : 0;
  }
  const Distribution2D distribution(k_width, k_height, weights);
  std::vector<int> counts(weights.size());
  for (int i = 0; i < k_samples; ++i) {
    const auto sample = distribution.sample({uniform(random), uniform(random)});
    const int x = static_cast<int>(sample.position.x * k_width);
    const int y = static_cast<int>(sample.position.y * k_height);
    ++counts[static_cast<std::size_t>(y * k_width + x)];
    ASSERT_EQ(sample.pdf, distribution.pdf(sample.position));
    ASSERT_GT(sample.pdf, 0.0f);
  }
  EXPECT_LT(std::abs(wilson_hilferty(chi_squared(counts, probabilities, k_samples), cells - 1)),
            4.0);
}

TEST(Distribution2D, Pdf_IntegratesToOneAndIsTheShareOfEachCell) {
  std::mt19937 random(29);
  const std::vector<float> weights = random_weights(16 * 8, random);
  double total = 0.0;
  for (const float weight : weights) total += weight;
  const Distribution2D distribution(16, 8, weights);
  double integral = 0.0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const float pdf = distribution.pdf(
          {(static_cast<float>(x) + 0.5f) / 16.0f, (static_cast<float>(y) + 0.5f) / 8.0f});
      EXPECT_NEAR(pdf, weights[static_cast<std::size_t>(16 * y + x)] / total * 128.0, 1e-4);
      integral += pdf / 128.0;
    }
  }
  EXPECT_NEAR(integral, 1.0, 1e-5);
}

TEST(Distribution2D, CornersOfTheSquare_StayInside) {
  const Distribution2D distribution(3, 2, std::vector<float>{0, 1, 0, 1, 0, 1});
  for (const float u : {0.0f, k_below_one, 1.0f}) {
    for (const float v : {0.0f, k_below_one, 1.0f}) {
      const auto sample = distribution.sample({u, v});
      EXPECT_GT(sample.pdf, 0.0f);
      EXPECT_LT(sample.position.x, 1.0f);
      EXPECT_LT(sample.position.y, 1.0f);
      EXPECT_GE(distribution.pdf({u, v}), 0.0f);
    }
  }
}

}  // namespace
}  // namespace lume::shading
