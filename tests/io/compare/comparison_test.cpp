// SPDX-License-Identifier: Apache-2.0
#include "io/compare/comparison.h"

#include "tests/io/compare/images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::io {
namespace {

using test::file_of;
using test::random_image;
using testing::HasSubstr;

const std::vector<std::string> k_rgba = {"R", "G", "B", "A"};

ChannelImage some_image() {
  test::Random random(5);
  return random_image(random, 12, 9, {"R", "G", "B", "A", "N.x", "N.y", "N.z", "depth.Z"});
}

Comparison compare(ChannelImage actual, ChannelImage expected, const CompareLimits& limits = {}) {
  return compare_images(file_of("actual.exr", std::move(actual)),
                        file_of("expected.exr", std::move(expected)), {limits});
}

double value_of(const Comparison& comparison, const std::string& name) {
  const auto found = std::find_if(comparison.verdicts.begin(), comparison.verdicts.end(),
                                  [&](const MetricVerdict& metric) { return metric.name == name; });
  EXPECT_NE(found, comparison.verdicts.end()) << name;
  return found == comparison.verdicts.end() ? std::nan("") : found->value;
}

TEST(Comparison, EqualImages_PassWithoutLimits) {
  const Comparison comparison = compare(some_image(), some_image());
  EXPECT_EQ(comparison.refusal, Refusal::none);
  EXPECT_TRUE(comparison.identical());
  EXPECT_TRUE(comparison.passed);
  EXPECT_EQ(comparison.groups.size(), 3u);
  EXPECT_EQ(comparison.flip.max, 0.0);
  EXPECT_DOUBLE_EQ(comparison.ssim, 1.0);
}

TEST(Comparison, OneValueByOneUnit_FailsWithoutLimits) {
  ChannelImage actual = some_image();
  float& value = actual.planes[5][40];
  value = std::nextafter(value, 2.0f);
  const Comparison comparison = compare(actual, some_image());
  EXPECT_FALSE(comparison.identical());
  EXPECT_FALSE(comparison.passed);
  const auto worst =
      std::max_element(comparison.groups.begin(), comparison.groups.end(),
                       [](const auto& a, const auto& b) { return a.metrics.max < b.metrics.max; });
  EXPECT_EQ(worst->name, "N");
  EXPECT_EQ(worst->worst_channel, "N.y");
  EXPECT_EQ(worst->worst_x, 40 % 12);
  EXPECT_EQ(worst->worst_y, 40 / 12);
}

TEST(Comparison, OrderOfChannels_DoesNotMatter) {
  ChannelImage actual = some_image();
  std::reverse(actual.channels.begin(), actual.channels.end());
  std::reverse(actual.planes.begin(), actual.planes.end());
  const Comparison comparison = compare(actual, some_image());
  EXPECT_TRUE(comparison.identical());
  EXPECT_TRUE(comparison.passed);
}

TEST(Comparison, NonFiniteValues_AreRefusedOnEitherSide) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    ChannelImage broken = some_image();
    broken.planes[2][13] = bad;
    const CompareLimits generous{.max = 1e30};
    const Comparison first = compare(broken, some_image(), generous);
    EXPECT_EQ(first.refusal, Refusal::non_finite);
    EXPECT_FALSE(first.passed);
    EXPECT_THAT(first.message, HasSubstr("actual.exr: one value of channel B is not finite"));
    EXPECT_THAT(first.message, HasSubstr("at (1, 1)"));
    EXPECT_THAT(compare(some_image(), broken).message, HasSubstr("expected.exr"));
    EXPECT_EQ(compare(broken, broken).refusal, Refusal::non_finite);
  }
}

TEST(Comparison, WhatDoesNotFit_IsRefusedInOrder) {
  test::Random random(1);
  const ChannelImage expected = random_image(random, 8, 6, k_rgba);
  ChannelImage other = random_image(random, 7, 6, {"R", "G", "B"});
  EXPECT_EQ(compare(other, expected).refusal, Refusal::size);

  other = random_image(random, 8, 6, {"R", "G", "B"});
  other.region = {1, 0, 7, 6};
  for (auto& plane : other.planes) plane.resize(7 * 6);
  const Comparison window = compare(other, expected);
  EXPECT_EQ(window.refusal, Refusal::data_window);
  EXPECT_THAT(window.message, HasSubstr("7x6+1+0, 8x6+0+0 is expected"));

  const Comparison channels = compare(random_image(random, 8, 6, {"R", "G", "B"}), expected);
  EXPECT_EQ(channels.refusal, Refusal::channels);
  EXPECT_THAT(channels.message, HasSubstr("B G R; expected are A B G R"));

  ImageFile two = file_of("two.exr", expected);
  two.images.push_back(expected);
  EXPECT_EQ(compare_images(two, file_of("one.exr", expected), {}).refusal, Refusal::channels);
}

TEST(Comparison, Limits_HoldToTheLastDigit) {
  ChannelImage actual = some_image();
  test::Random random(9);
  for (int c = 0; c < 3; ++c) {
    for (float& value : actual.planes[static_cast<std::size_t>(c)])
      value += random.uniform(0, 0.1f);
  }
  const Comparison measured = compare(actual, some_image());
  using Limit = std::optional<double> CompareLimits::*;
  const std::pair<const char*, Limit> most[] = {
      {"max", &CompareLimits::max},           {"mae", &CompareLimits::mae},
      {"rmse", &CompareLimits::rmse},         {"relmse", &CompareLimits::relmse},
      {"outliers", &CompareLimits::outliers}, {"flip", &CompareLimits::flip},
      {"flip_max", &CompareLimits::flip_max}};
  for (const auto& [name, limit] : most) {
    const double value = value_of(measured, name);
    ASSERT_GT(value, 0.0) << name;
    CompareLimits limits;
    limits.*limit = value;
    EXPECT_TRUE(compare(actual, some_image(), limits).passed) << name;
    limits.*limit = std::nextafter(value, 0.0);
    EXPECT_FALSE(compare(actual, some_image(), limits).passed) << name;
  }
  const std::pair<const char*, Limit> least[] = {{"psnr", &CompareLimits::psnr},
                                                 {"ssim", &CompareLimits::ssim}};
  for (const auto& [name, limit] : least) {
    const double value = value_of(measured, name);
    CompareLimits limits;
    limits.*limit = value;
    EXPECT_TRUE(compare(actual, some_image(), limits).passed) << name;
    limits.*limit = std::nextafter(value, 1e9);
    EXPECT_FALSE(compare(actual, some_image(), limits).passed) << name;
  }
}

TEST(Comparison, LayerBesideTheColour_IsHeldToTheLimitsToo) {
  ChannelImage actual = some_image();
  actual.planes[7][3] += 0.5f;
  const Comparison comparison = compare(actual, some_image(), {.max = 0.1});
  EXPECT_FALSE(comparison.passed);
  EXPECT_NEAR(value_of(comparison, "depth: max"), 0.5, 1e-6);
  EXPECT_EQ(value_of(comparison, "max"), 0.0);
}

TEST(Comparison, NoColour_IsComparedByValues) {
  test::Random random(2);
  const ChannelImage depth = random_image(random, 4, 4, {"depth.Z", "id.X"});
  const Comparison comparison = compare(depth, depth);
  EXPECT_FALSE(comparison.has_color);
  EXPECT_TRUE(comparison.flip_map.empty());
  EXPECT_TRUE(comparison.passed);
}

TEST(Comparison, KindOfFlip_IsThatOfTheImages) {
  ChannelImage image = some_image();
  EXPECT_TRUE(compare(image, image).is_hdr);
  image.display_referred = true;
  EXPECT_FALSE(compare(image, image).is_hdr);
  EXPECT_FALSE(compare(image, some_image()).is_hdr);
}

}  // namespace
}  // namespace lume::io
