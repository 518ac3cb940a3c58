// SPDX-License-Identifier: Apache-2.0
#include "renderer/sampler.h"

#include "tests/support/chi_squared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lume::renderer {
namespace {

TEST(Sampler, SameArguments_GiveSameNumbers) {
  for (std::uint32_t s = 0; s < 100; ++s) {
    const Vec2 a = Sampler(7, 3, 4, s).branch(2).get_2d(5);
    EXPECT_EQ(a, Sampler(7, 3, 4, s).branch(2).get_2d(5));
  }
}

TEST(Sampler, EveryArgument_Matters) {
  const Vec2 base = Sampler(7, 3, 4, 9).branch(2).get_2d(5);
  EXPECT_NE(base, Sampler(8, 3, 4, 9).branch(2).get_2d(5));
  EXPECT_NE(base, Sampler(7, 4, 3, 9).branch(2).get_2d(5));
  EXPECT_NE(base, Sampler(7, 3, 5, 9).branch(2).get_2d(5));
  EXPECT_NE(base, Sampler(7, 3, 4, 8).branch(2).get_2d(5));
  EXPECT_NE(base, Sampler(7, 3, 4, 9).branch(1).get_2d(5));
  EXPECT_NE(base, Sampler(7, 3, 4, 9).get_2d(5));
  EXPECT_NE(base, Sampler(7, 3, 4, 9).branch(2).get_2d(6));
}

/// Number of the elementary interval that a point lies in: columns * rows = 2^bits of them.
std::size_t interval(Vec2 point, int column_bits, int bits) {
  const auto x = static_cast<std::size_t>(std::ldexp(point.x, column_bits));
  const auto y = static_cast<std::size_t>(std::ldexp(point.y, bits - column_bits));
  return (x << (bits - column_bits)) | y;
}

TEST(Sampler, SamplesOfAPixel_FillEveryElementaryIntervalOnce) {
  // The defining property of a (0,2)-sequence, which Owen scrambling and shuffling keep.
  for (int pixel = 0; pixel < 20; ++pixel) {
    for (int bits = 0; bits <= 8; ++bits) {
      for (int column_bits = 0; column_bits <= bits; ++column_bits) {
        std::set<std::size_t> seen;
        const std::uint32_t count = 1u << bits;
        for (std::uint32_t s = 0; s < count; ++s) {
          const Vec2 point = Sampler(1, pixel, 2 * pixel, s).branch(3).get_2d(4);
          ASSERT_GE(std::min(point.x, point.y), 0.0f);
          ASSERT_LT(std::max(point.x, point.y), 1.0f);
          seen.insert(interval(point, column_bits, bits));
        }
        ASSERT_EQ(seen.size(), count) << "pixel " << pixel << " 2^" << column_bits << " columns";
      }
    }
  }
}

TEST(Sampler, PointsOverPixelsAndDimensions_AreUniformAndIndependent) {
  constexpr int k_cells = 8;
  constexpr int k_pixels = 200;
  // Cells of (x of one dimension, y of another dimension, sample 0) over many pixels.
  std::vector<double> counts(k_cells * k_cells * k_cells, 0.0);
  for (int y = 0; y < k_pixels; ++y) {
    for (int x = 0; x < k_pixels; ++x) {
      const Sampler sampler(5, x, y, 0);
      const Vec2 a = sampler.get_2d(1);
      const Vec2 b = sampler.branch(1).get_2d(1);
      const auto cell = [](float value) { return static_cast<std::size_t>(value * k_cells); };
      counts[(cell(a.x) * k_cells + cell(a.y)) * k_cells + cell(b.x)] += 1.0;
    }
  }
  const std::vector<double> expected(
      counts.size(), static_cast<double>(k_pixels * k_pixels) / static_cast<double>(counts.size()));
  test::expect_chi_squared(counts, expected);
}

TEST(Sampler, Integration_ConvergesFasterThanRandom) {
  // Mean of x*y over 256 samples; its error for random points is about 0.22 / 16 = 0.014.
  double squared_error = 0.0;
  constexpr int k_pixels = 200;
  for (int pixel = 0; pixel < k_pixels; ++pixel) {
    double mean = 0.0;
    for (std::uint32_t s = 0; s < 256; ++s) {
      const Vec2 p = Sampler(2, pixel, 0, s).get_2d(0);
      mean += static_cast<double>(p.x * p.y) / 256.0;
    }
    squared_error += (mean - 0.25) * (mean - 0.25) / k_pixels;
  }
  EXPECT_LT(std::sqrt(squared_error), 0.001);
}

}  // namespace
}  // namespace lume::renderer
