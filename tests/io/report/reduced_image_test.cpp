// SPDX-License-Identifier: Apache-2.0
#include "io/report/reduced_image.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lume::io {
namespace {

TEST(ReducedImage, Factor_IsTheSmallestThatFits) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const int width = 1 + static_cast<int>(random.below(5000));
    const int height = 1 + static_cast<int>(random.below(5000));
    const SizeLimit limit{1 + static_cast<int>(random.below(3000)), 1 + random.below(2'000'000)};
    const auto fits = [&](int factor) {
      const int columns = (width + factor - 1) / factor;
      const int rows = (height + factor - 1) / factor;
      return columns <= limit.side && rows <= limit.side &&
             static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) <= limit.pixels;
    };
    const int factor = reduction_factor(width, height, limit);
    ASSERT_TRUE(fits(factor));
    ASSERT_TRUE(factor == 1 || !fits(factor - 1));
  }
}

TEST(ReducedImage, Pixels_AreMeansOfSquaresCutOffAtTheEdges) {
  RgbImage image{5, 3, {}};
  std::vector<float> map;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const auto value = static_cast<float>(10 * y + x);
      image.pixels.emplace_back(value, 2.0f * value, -value);
      map.push_back(value);
    }
  }
  const RgbImage reduced = reduce(image, 2);
  const std::vector<float> expected = {5.5f, 7.5f, 9.0f, 20.5f, 22.5f, 24.0f};
  EXPECT_EQ(reduce(map, 5, 3, 2), expected);
  ASSERT_EQ(reduced.width, 3);
  ASSERT_EQ(reduced.height, 2);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(reduced.pixels[i], shading::Color(expected[i], 2.0f * expected[i], -expected[i]));
  }
}

}  // namespace
}  // namespace lume::io
