// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_hdr.h"

#include "io/compare/flip_tiles.h"
#include "tests/io/compare/flip_pictures.h"
#include "tests/io/compare/plain_flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lume::io {
namespace {

using shading::Color;
using tests::flat_picture;
using tests::make_picture;
using tests::noise_picture;
using tests::plain_flip_hdr;
using tests::scene_picture;

constexpr float k_largest = std::numeric_limits<float>::max();
constexpr float k_infinity = std::numeric_limits<float>::infinity();
constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

/// A scene with values from 0.001 to 100.
RgbImage bright_scene(int width, int height, int move) {
  RgbImage image = scene_picture(width, height, move, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Color& pixel = image.pixels[static_cast<std::size_t>(y * width + x)];
      pixel *= std::pow(10.0f, 4.0f * static_cast<float>(y) / static_cast<float>(height) - 2.0f);
    }
  }
  return image;
}

void expect_plain(const RgbImage& reference, const RgbImage& test) {
  const std::vector<float> fast = flip_hdr(reference, test).error;
  const std::vector<double> plain = plain_flip_hdr(reference, test, k_flip_pixels_per_degree);
  ASSERT_EQ(fast.size(), plain.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(fast[i]) - plain[i]));
  }
  // The plain one stores what the display shows in floats.
  EXPECT_LT(worst, 2e-5);
}

void expect_valid(const HdrFlip& result) {
  for (std::size_t i = 0; i < result.error.size(); ++i) {
    EXPECT_GE(result.error[i], 0.0f);
    EXPECT_LE(result.error[i], 1.0f);
    EXPECT_GE(result.worst[i], 0);
    EXPECT_LT(result.worst[i], result.exposures.count);
  }
}

TEST(ToneMapAces, Inverse_LeadsBack) {
  for (int i = 1; i < 100; ++i) {
    const double y = 0.01 * i;
    EXPECT_NEAR(tone_map_aces(inverse_tone_map_aces(y)), y, 1e-12);
  }
  EXPECT_EQ(tone_map_aces(0.0), 0.0);
}

TEST(FlipHdr, Pictures_AsPlainFormulas) {
  expect_plain(bright_scene(27, 31, 0), bright_scene(27, 31, 1));
  expect_plain(bright_scene(31, 20, 0), noise_picture(31, 20, 1, 5.0f));
  expect_plain(noise_picture(8, 3, 2, 0.01f), noise_picture(8, 3, 3, 0.02f));
}

TEST(FlipHdr, EqualPictures_Zero) {
  const RgbImage image = bright_scene(20, 20, 0);
  for (const float error : flip_hdr(image, image).error) EXPECT_EQ(error, 0.0f);
}

// The brightest and the median pixel become 0.85 at either end.
TEST(FlipExposures, Range_FromBrightestToMedian) {
  const RgbImage image =
      make_picture(5, 1, [](int x, int) { return Color(std::pow(4.0f, static_cast<float>(x))); });
  const FlipExposures exposures = flip_exposures(image);
  EXPECT_NEAR(tone_map_aces(std::exp2(exposures.first) * 256.0), 0.85, 1e-9);
  EXPECT_NEAR(tone_map_aces(std::exp2(exposures.last) * 16.0), 0.85, 1e-9);
  EXPECT_NEAR(exposures.last - exposures.first, 4.0, 1e-9);
  EXPECT_EQ(exposures.stop(0), exposures.first);
  EXPECT_NEAR(exposures.stop(exposures.count - 1), exposures.last, 1e-12);
}

TEST(FlipExposures, Count_OneForEachStop) {
  const auto count = [](float most) {
    const RgbImage image =
        make_picture(3, 1, [most](int x, int) { return Color(x == 0 ? most : 1.0f); });
    return flip_exposures(image).count;
  };
  EXPECT_EQ(count(1.0f), 2);
  EXPECT_EQ(count(3.0f), 2);
  EXPECT_EQ(count(12.0f), 4);
  EXPECT_EQ(count(1000.0f), 10);
  EXPECT_EQ(count(k_largest), k_flip_most_exposures);
}

TEST(FlipExposures, BlackPixels_LeftOutIfTheyAreMost) {
  const auto last = [](int black) {
    return flip_exposures(make_picture(10, 1,
                                       [black](int x, int) {
                                         return Color(x < black ? 0.0f
                                                                : static_cast<float>(1 << x));
                                       }))
        .last;
  };
  // Of 0, 0, 4, 8 ... 512 the middle is between 16 and 32; of 128, 256 and 512 it is 256.
  const double white = std::log2(inverse_tone_map_aces(0.85));
  EXPECT_NEAR(last(2), white - std::log2(24.0), 1e-9);
  EXPECT_NEAR(last(7), white - std::log2(256.0), 1e-9);
}

TEST(FlipExposures, NoLight_OneExposure) {
  for (const float dark : {0.0f, -5.0f, k_nan, -k_infinity}) {
    const FlipExposures exposures = flip_exposures(flat_picture(Color(dark)));
    EXPECT_EQ(exposures.first, 0.0);
    EXPECT_EQ(exposures.count, 1);
  }
  EXPECT_EQ(flip_exposures({}).count, 1);
}

// The same pictures, brighter by a power of two, have the same errors.
TEST(FlipHdr, BrighterPictures_SameErrors) {
  const RgbImage reference = bright_scene(24, 24, 0);
  const RgbImage test = bright_scene(24, 24, 1);
  RgbImage more_reference = reference;
  RgbImage more_test = test;
  for (Color& c : more_reference.pixels) c *= 1024.0f;
  for (Color& c : more_test.pixels) c *= 1024.0f;
  const HdrFlip a = flip_hdr(reference, test);
  const HdrFlip b = flip_hdr(more_reference, more_test);
  EXPECT_NEAR(a.exposures.first - b.exposures.first, 10.0, 1e-9);
  for (std::size_t i = 0; i < a.error.size(); ++i) EXPECT_NEAR(a.error[i], b.error[i], 1e-6);
}

TEST(FlipHdr, EachExposure_IsNoWorseThanTheResult) {
  const RgbImage reference = bright_scene(24, 18, 0);
  const RgbImage test = bright_scene(24, 18, 1);
  const HdrFlip all = flip_hdr(reference, test);
  ASSERT_GT(all.exposures.count, 3);
  std::vector<float> worst(all.error.size(), 0.0f);
  for (int i = 0; i < all.exposures.count; ++i) {
    const double stop = all.exposures.stop(i);
    const HdrFlip one = flip_hdr(reference, test, FlipExposures{stop, stop, 1});
    for (std::size_t p = 0; p < worst.size(); ++p) {
      worst[p] = std::max(worst[p], one.error[p]);
      if (all.worst[p] == i) {
        EXPECT_EQ(one.error[p], all.error[p]);
      }
    }
  }
  EXPECT_EQ(worst, all.error);
  EXPECT_NE(*std::min_element(all.worst.begin(), all.worst.end()),
            *std::max_element(all.worst.begin(), all.worst.end()));
}

TEST(FlipHdr, EqualExposures_TheFirstIsTheWorst) {
  const RgbImage reference = noise_picture(12, 9, 6);
  const HdrFlip result = flip_hdr(reference, noise_picture(12, 9, 7), FlipExposures{0.5, 0.5, 3});
  EXPECT_GT(result.error[0], 0.0f);
  for (const int worst : result.worst) EXPECT_EQ(worst, 0);
}

TEST(FlipHdr, ErrorInTheDark_SeenAtALongExposure) {
  const auto scene = [](float dark) {
    return make_picture(40, 8, [dark](int x, int) { return Color(x < 4 ? 1000.0f : dark); });
  };
  const RgbImage reference = scene(1.0f);
  const RgbImage test = scene(1.5f);
  constexpr std::size_t k_dark_pixel = 4 * 40 + 30;
  const HdrFlip all = flip_hdr(reference, test);
  const double first = all.exposures.first;
  const HdrFlip shortest = flip_hdr(reference, test, FlipExposures{first, first, 1});
  EXPECT_GT(all.worst[k_dark_pixel], all.exposures.count / 2);
  EXPECT_GT(all.error[k_dark_pixel], 10.0f * shortest.error[k_dark_pixel]);
}

TEST(FlipHdr, ValuesOfAnySize_ErrorsInRange) {
  const auto odd = [](int x, int) {
    constexpr std::array<float, 8> k_values = {0.0f,  -1.0f,     1e-40f,     1.0f,
                                               1e20f, k_largest, -k_largest, k_nan};
    return Color(k_values[static_cast<std::size_t>(x) % 8], 0.5f,
                 k_values[static_cast<std::size_t>(x / 3) % 8]);
  };
  const RgbImage strange = make_picture(24, 6, odd);
  const RgbImage tame = noise_picture(24, 6, 4);
  expect_valid(flip_hdr(strange, tame));
  expect_valid(flip_hdr(tame, strange));
  expect_valid(flip_hdr(flat_picture(Color(k_infinity), 24, 6), tame));
  expect_valid(flip_hdr(flat_picture(Color(0.0f), 24, 6), tame));
  EXPECT_TRUE(flip_hdr({}, {}).error.empty());
}

TEST(FlipHdr, NegativeValues_AreBlack) {
  const RgbImage other = noise_picture(9, 9, 5, 3.0f);
  EXPECT_EQ(flip_hdr(other, flat_picture(Color(-2.0f), 9, 9)).error,
            flip_hdr(other, flat_picture(Color(0.0f), 9, 9)).error);
}

}  // namespace
}  // namespace lume::io
