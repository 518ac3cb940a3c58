// SPDX-License-Identifier: Apache-2.0
#include "io/compare/statistical_test.h"

#include "tests/io/compare/synthetic_render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lume::io {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr test::SyntheticPicture k_picture{40, 24};

/// Stacks of a constant picture.
EstimateStack constant_stack(float value, int images) {
  return test::render_stack([=](test::Noise&, int, int) { return static_cast<double>(value); },
                            k_picture, {images, 1}, 0);
}

EstimateStack noisy_stack(std::uint64_t seed, int images = 8) {
  return test::render_stack(test::gaussian_sample, k_picture, {images, 1}, seed);
}

std::size_t index(int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(k_picture.width) +
         static_cast<std::size_t>(x);
}

TEST(StatisticalTest, EqualConstants_Pass) {
  const StatisticalResult result = test_stacks(constant_stack(0.3f, 7), constant_stack(0.3f, 9));
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.pixels.smallest_p(), 1.0);
  EXPECT_EQ(result.tiles.tests, 6u);  // 16 + 16 + 8 pixels by 16 + 8
  EXPECT_EQ(result.pixels.tests, 960u);
  EXPECT_EQ(result.image.tests, 1u);
  EXPECT_NEAR(result.image.detectable_bias.value(), 1e-6, 1e-12);  // rounding is no bias
}

TEST(StatisticalTest, OtherConstantInOnePixel_IsCertainFailure) {
  for (const int images : {2, 8}) {
    EstimateStack actual = constant_stack(0.3f, images);
    for (auto& image : actual.images) image[0][index(17, 9)] = 0.3001f;
    const StatisticalResult result = test_stacks(actual, constant_stack(0.3f, images));
    EXPECT_FALSE(result.passed);
    EXPECT_FALSE(result.pixels.passed);
    EXPECT_EQ(result.pixels.smallest_p(), 0.0);
    EXPECT_EQ(result.pixels.x, 17);
    EXPECT_EQ(result.pixels.y, 9);
    EXPECT_EQ(result.pixels.channel, "Y");
    EXPECT_NEAR(result.pixels.difference, 1e-4, 1e-7);
    EXPECT_NEAR(result.pixels.relative_difference, 1e-4 / 0.3, 1e-6);
    EXPECT_EQ(result.tiles.x, 16);
    EXPECT_EQ(result.tiles.y, 0);
  }
}

TEST(StatisticalTest, OtherConstantInANoisyPicture_IsFound) {
  EstimateStack actual = noisy_stack(1);
  EstimateStack expected = noisy_stack(2);
  for (auto& image : actual.images) image[0][index(3, 4)] = 1.01f;
  for (auto& image : expected.images) image[0][index(3, 4)] = 1.0f;
  const StatisticalResult result = test_stacks(actual, expected);
  EXPECT_FALSE(result.pixels.passed);
  EXPECT_EQ(result.pixels.x, 3);
  EXPECT_EQ(result.pixels.y, 4);
  // The only pixel that is certain: no other labels show it, and the answer is a 300th at best.
  EXPECT_NEAR(result.pixels.exchange_p.value(), 1.0 / 300.0, 1e-6);
}

TEST(StatisticalTest, TinySignificance_EndsAndFindsWhatIsSure) {
  const StatisticalSettings strict{.significance = 1e-12};
  EXPECT_TRUE(test_stacks(noisy_stack(1, 40), noisy_stack(2, 40), strict).passed);
  EXPECT_FALSE(test_stacks(constant_stack(1.0f, 8), constant_stack(2.0f, 8), strict).image.passed);
}

TEST(StatisticalTest, Rounding_IsNoDifference) {
  const float next = std::nextafter(0.3f, 1.0f);
  EXPECT_TRUE(test_stacks(constant_stack(next, 8), constant_stack(0.3f, 8)).passed);
  EXPECT_FALSE(
      test_stacks(constant_stack(next, 8), constant_stack(0.3f, 8), {.rounding = 0.0}).passed);
  EXPECT_FALSE(test_stacks(constant_stack(0.30001f, 8), constant_stack(0.3f, 8)).passed);
  // A half has 11 bits.
  EXPECT_TRUE(test_stacks(constant_stack(0.3001f, 8), constant_stack(0.3f, 8),
                          {.rounding = std::ldexp(1.0, -11)})
                  .passed);
}

TEST(StatisticalTest, OneFirefly_NeitherFailsNorHides) {
  for (const std::uint64_t seed : {10u, 20u, 30u, 40u}) {
    EstimateStack actual = noisy_stack(seed);
    const EstimateStack expected = noisy_stack(seed + 1);
    actual.images[3][0][index(5, 5)] = 1e5f;
    const StatisticalResult clean = test_stacks(actual, expected);
    EXPECT_TRUE(clean.passed) << describe(clean);
    EXPECT_EQ(clean.fireflies, 1u);
    for (auto& image : actual.images) {
      for (float& value : image[0]) value *= 1.3f;
    }
    const StatisticalResult biased = test_stacks(actual, expected);
    EXPECT_FALSE(biased.image.passed);
    EXPECT_TRUE(biased.image.without_fireflies);
    EXPECT_FALSE(biased.tiles.passed);
  }
}

TEST(StatisticalTest, FirefliesOfOneSideOnly_Fail) {
  // Left out of the robust tests, they are still in the plain ones.
  const auto sampler = [](test::Noise& noise, int x, int y) {
    return test::gaussian_sample(noise, x, y) + noise.bernoulli(0.01, 200.0);
  };
  const StatisticalResult result =
      test_stacks(test::render_stack(sampler, k_picture, {8, 4}, 1),
                  test::render_stack(test::gaussian_sample, k_picture, {8, 4}, 2));
  EXPECT_FALSE(result.image.passed);
  EXPECT_FALSE(result.image.without_fireflies);
}

TEST(StatisticalTest, SwappedSides_SwapTheSignOnly) {
  const EstimateStack a = test::render_stack(test::texture_sample, k_picture, {8, 2}, 1);
  const EstimateStack b = test::render_stack(test::texture_sample, k_picture, {12, 2}, 2);
  const StatisticalResult forth = test_stacks(a, b);
  const StatisticalResult back = test_stacks(b, a);
  for (const auto family :
       {&StatisticalResult::pixels, &StatisticalResult::tiles, &StatisticalResult::image}) {
    EXPECT_NEAR((forth.*family).smallest_log_p, (back.*family).smallest_log_p, 1e-6);
    EXPECT_NEAR((forth.*family).difference, -(back.*family).difference, 1e-6);
    EXPECT_EQ((forth.*family).x, (back.*family).x);
    EXPECT_EQ((forth.*family).y, (back.*family).y);
  }
}

TEST(StatisticalTest, EachChannel_IsTested) {
  const auto stack = [](std::uint64_t seed, float bias) {
    EstimateStack red = noisy_stack(seed);
    const EstimateStack green = noisy_stack(seed + 500);
    red.shape.channels = {"R", "G"};
    for (std::size_t k = 0; k < red.images.size(); ++k) {
      red.images[k].push_back(green.images[k][0]);
      for (float& value : red.images[k][1]) value *= bias;
    }
    return red;
  };
  EXPECT_TRUE(test_stacks(stack(1, 1.0f), stack(2, 1.0f)).passed);
  const StatisticalResult result = test_stacks(stack(1, 1.1f), stack(2, 1.0f));
  EXPECT_FALSE(result.image.passed);
  EXPECT_EQ(result.image.channel, "G");
  EXPECT_NEAR(result.image.relative_difference, 0.1, 0.02);
  EXPECT_EQ(result.image.tests, 2u);
  EXPECT_NEAR(result.image.threshold, 0.01 / 3.0 / 2.0, 1e-12);
}

TEST(StatisticalTest, Black_HasNoRelativeBias) {
  const StatisticalResult result = test_stacks(constant_stack(0.0f, 8), constant_stack(0.0f, 8));
  EXPECT_TRUE(result.passed);
  EXPECT_FALSE(result.image.detectable_bias.has_value());
  EXPECT_THAT(describe(result), HasSubstr("black"));
  const StatisticalResult lit = test_stacks(constant_stack(1.0f, 8), constant_stack(0.0f, 8));
  EXPECT_FALSE(lit.passed);
  EXPECT_TRUE(std::isinf(lit.image.relative_difference));
}

TEST(StatisticalTest, Description_SaysWhatAPassIsWorthAndWhatFailedWhere) {
  const StatisticalResult passed = test_stacks(noisy_stack(1), noisy_stack(2));
  EXPECT_THAT(describe(passed), StartsWith("would have seen a bias of "));
  EXPECT_THAT(describe(passed), HasSubstr("% of the whole image or "));
  EstimateStack broken = noisy_stack(3);
  for (auto& image : broken.images) image[0][index(7, 11)] += 50.0f;
  const std::string text = describe(test_stacks(broken, noisy_stack(2)));
  EXPECT_THAT(text, HasSubstr("pixel (7, 11) in Y: +50"));
}

TEST(StatisticalTest, Moments_AgreeWithStacks) {
  // Means and variances over a stack are a picture with variances, of which each is as good.
  const EstimateStack a = noisy_stack(1, 12);
  const EstimateStack b = noisy_stack(2, 12);
  const auto moments = [](const EstimateStack& stack) {
    const auto count = static_cast<float>(stack.images.size());
    EstimateMoments result{stack.shape,
                           {std::vector<float>(stack.shape.pixels())},
                           {std::vector<float>(stack.shape.pixels())},
                           12};
    for (std::size_t i = 0; i < stack.shape.pixels(); ++i) {
      float& mean = result.mean[0][i];
      float& variance = result.variance[0][i];
      for (const auto& image : stack.images) mean += image[0][i] / count;
      for (const auto& image : stack.images) {
        variance += (image[0][i] - mean) * (image[0][i] - mean) / (count * (count - 1.0f));
      }
    }
    return result;
  };
  const StatisticalResult of_stacks = test_stacks(a, b);
  const StatisticalResult of_moments = test_moments(moments(a), moments(b));
  EXPECT_NEAR(of_moments.pixels.smallest_log_p, of_stacks.pixels.smallest_log_p, 1e-3);
  EXPECT_EQ(of_moments.pixels.x, of_stacks.pixels.x);
  EXPECT_EQ(of_moments.pixels.y, of_stacks.pixels.y);
  EXPECT_NEAR(of_moments.image.difference, of_stacks.image.difference, 1e-6);
}

template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(StatisticalTest, WhatCannotBeCompared_IsRefused) {
  const EstimateStack good = noisy_stack(1);
  const auto refusal = [&](const EstimateStack& bad) {
    return message_of([&] { (void)test_stacks(bad, good); });
  };
  EstimateStack bad = good;
  bad.images.resize(1);
  EXPECT_THAT(refusal(bad), HasSubstr("at least 2"));
  bad = good;
  bad.shape.width = 39;
  EXPECT_THAT(refusal(bad), HasSubstr("expected 40 x 24"));
  bad = good;
  bad.shape.channels = {"R"};
  EXPECT_THAT(refusal(bad), HasSubstr("channels R, expected Y"));
  bad = good;
  bad.images[2][0].pop_back();
  EXPECT_THAT(refusal(bad), HasSubstr("959 values, expected 960"));
  bad = good;
  bad.images[2][0][3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal(bad), HasSubstr("finite"));
  EXPECT_THAT(message_of([&] { (void)test_stacks(good, good, {.significance = 0.0}); }),
              HasSubstr("significance"));
  EXPECT_THAT(message_of([&] { (void)test_stacks(good, good, {.tile_size = 0}); }),
              HasSubstr("tiles"));
  EXPECT_THAT(message_of([&] { (void)test_stacks({}, {}); }), HasSubstr("0 x 0"));
  EstimateMoments moments = test::render_moments(test::gaussian_sample, k_picture, 4, 1);
  const EstimateMoments other = moments;
  moments.variance[0][0] = -1.0f;
  EXPECT_THAT(message_of([&] { (void)test_moments(moments, other); }), HasSubstr("negative"));
}

}  // namespace
}  // namespace lume::io
