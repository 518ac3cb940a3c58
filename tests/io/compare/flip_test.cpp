// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip.h"

#include "geometry/parallel.h"
#include "io/compare/flip_color.h"
#include "io/compare/flip_filters.h"
#include "tests/io/compare/flip_pictures.h"
#include "tests/io/compare/plain_flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace lume::io {
namespace {

using shading::Color;
using tests::flat_picture;
using tests::make_picture;
using tests::noise_picture;
using tests::plain_flip;
using tests::scene_picture;

Color grey(int code) { return Color(shading::srgb_to_linear(static_cast<float>(code) / 255.0f)); }

/// Nothing but colour differs between flat pictures.
void expect_flat(const Color& reference, const Color& test, double error) {
  for (const float value : flip(flat_picture(reference), flat_picture(test))) {
    EXPECT_NEAR(value, error, 1e-6);
  }
}

void expect_plain(const RgbImage& reference, const RgbImage& test,
                  double pixels_per_degree = k_flip_pixels_per_degree) {
  const std::vector<float> fast = flip(reference, test, {pixels_per_degree});
  const std::vector<double> plain = plain_flip(reference, test, pixels_per_degree);
  ASSERT_EQ(fast.size(), plain.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(fast[i]) - plain[i]));
  }
  EXPECT_LT(worst, 1e-6) << reference.width << " x " << reference.height;
}

// Six digits of the reference implementation, which has no features to see here.
TEST(Flip, FlatColors_KnownErrors) {
  expect_flat({0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 1.0);
  expect_flat(Color(0.0f), Color(1.0f), 0.967380);
  expect_flat({1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.986662);
  expect_flat(grey(128), grey(129), 0.029855);
  expect_flat(grey(128), grey(138), 0.148985);
  expect_flat(grey(0), grey(1), 0.023259);
  EXPECT_NEAR(largest_color_distance(), 41.276099, 1e-6);
}

TEST(Flip, EqualPictures_Zero) {
  const RgbImage image = noise_picture(31, 17, 1);
  for (const float value : flip(image, image)) EXPECT_EQ(value, 0.0f);
}

TEST(Flip, Structures_AsPlainFormulas) {
  expect_plain(scene_picture(47, 31, 0, 0), scene_picture(47, 31, 1, 0));
  expect_plain(scene_picture(29, 43, 0, 0), scene_picture(29, 43, 0, 3));
  expect_plain(scene_picture(40, 40, 0, 0), noise_picture(40, 40, 2));
  // One bright pixel, and an edge that is not there.
  const RgbImage black = flat_picture(Color(0.0f), 33, 21);
  expect_plain(black, make_picture(33, 21, [](int x, int y) {
                 return Color(x == 20 && y == 7 ? 1.0f : 0.0f);
               }));
  expect_plain(black, make_picture(33, 21, [](int x, int) { return Color(x < 12 ? 1.0f : 0.0f); }));
}

TEST(Flip, SizesBelowTheFilters_AsPlainFormulas) {
  test::Random random(3);
  for (unsigned i = 0; i < 24; ++i) {
    const int width = 1 + static_cast<int>(random.below(24));
    const int height = 1 + static_cast<int>(random.below(12));
    expect_plain(noise_picture(width, height, 2 * i), noise_picture(width, height, 2 * i + 1));
  }
  expect_plain(noise_picture(1, 1, 4), noise_picture(1, 1, 5));
  expect_plain(noise_picture(50, 1, 4), noise_picture(50, 1, 5));
  expect_plain(noise_picture(1, 50, 4), noise_picture(1, 50, 5));
}

TEST(Flip, Distances_AsPlainFormulas) {
  for (const double pixels_per_degree : {1.0, 3.0, 10.0, 24.4, 40.0, 120.0}) {
    expect_plain(scene_picture(25, 19, 0, 0), noise_picture(25, 19, 6), pixels_per_degree);
  }
}

// Seams of the tiles, in both directions.
TEST(Flip, SeveralTiles_AsPlainFormulas) {
  expect_plain(scene_picture(261, 20, 0, 0), noise_picture(261, 20, 7));
  expect_plain(scene_picture(20, 199, 0, 0), noise_picture(20, 199, 8));
}

// What differs in one tile is seen in the next one, too.
TEST(Flip, OnePixel_SeenAcrossSeams) {
  const RgbImage reference = flat_picture({0.3f, 0.3f, 0.2f}, 275, 9);
  for (const int at : {240, 246, 247, 254, 255, 256, 260, 266}) {
    expect_plain(reference, make_picture(275, 9, [at](int x, int y) {
                   return x == at && y == 4 ? Color(1.0f) : Color(0.3f, 0.3f, 0.2f);
                 }));
  }
  const RgbImage high = flat_picture({0.3f, 0.3f, 0.2f}, 9, 115);
  for (const int at : {85, 86, 95, 96, 105, 106}) {
    expect_plain(high, make_picture(9, 115, [at](int x, int y) {
                   return x == 4 && y == at ? Color(1.0f) : Color(0.3f, 0.3f, 0.2f);
                 }));
  }
}

TEST(Flip, Exchange_SameErrors) {
  const RgbImage a = scene_picture(30, 20, 0, 0);
  const RgbImage b = scene_picture(30, 20, 2, 1);
  EXPECT_EQ(flip(a, b), flip(b, a));
}

TEST(Flip, AnyNumberOfThreads_SameErrors) {
  const RgbImage a = scene_picture(600, 200, 0, 0);
  const RgbImage b = noise_picture(600, 200, 9);
  std::vector<float> alone;
  {
    const geometry::ThreadLimit limit(1);
    alone = flip(a, b);
  }
  const geometry::ThreadLimit limit(4);
  EXPECT_EQ(flip(a, b), alone);
}

TEST(Flip, ValuesOutsideTheDisplay_Clamped) {
  constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  const RgbImage other = flat_picture({0.3f, 0.2f, 0.1f});
  EXPECT_EQ(flip(flat_picture({-3.0f, 0.5f, 1e30f}), other),
            flip(flat_picture({0.0f, 0.5f, 1.0f}), other));
  EXPECT_EQ(flip(flat_picture({k_nan, -k_infinity, k_infinity}), other),
            flip(flat_picture({0.0f, 0.0f, 1.0f}), other));
}

// Blurring makes fine grids grey, the finer the farther away.
TEST(Flip, FineChecker_FadesWithDistance) {
  const auto checker = [](int phase) {
    return make_picture(
        40, 40, [phase](int x, int y) { return Color((x + y + phase) % 2 == 0 ? 0.0f : 1.0f); });
  };
  const auto middle = [&](double pixels_per_degree) {
    return flip(checker(0), checker(1), {pixels_per_degree})[20 * 40 + 20];
  };
  EXPECT_GT(middle(5.0), 0.9f);
  EXPECT_LT(middle(k_flip_pixels_per_degree), 0.4f);
  EXPECT_LT(middle(200.0), 0.01f);
}

TEST(Flip, NoPixels_NoErrors) { EXPECT_TRUE(flip({}, {}).empty()); }

TEST(Flip, BadInput_Thrown) {
  const RgbImage image = flat_picture(Color(0.5f));
  EXPECT_THROW((void)flip(image, flat_picture(Color(0.5f), 5, 7)), std::invalid_argument);
  for (const double bad : {0.0, -1.0, 0.99, 1001.0, std::nan("")}) {
    EXPECT_THROW((void)flip(image, image, {bad}), std::invalid_argument) << bad;
  }
}

// 0.7 m away from 3840 pixels on 0.7 m.
TEST(Flip, DefaultDistance_AsInThePaper) {
  EXPECT_DOUBLE_EQ(k_flip_pixels_per_degree, 0.7 * 3840.0 / 0.7 * std::numbers::pi / 180.0);
}

double total(const Kernel& kernel) {
  double sum = kernel.center;
  for (const double weight : kernel.right) sum += weight * (kernel.odd ? 0.0 : 2.0);
  return sum;
}

TEST(FlipFilters, AnyDistance_SumsAsTheyShould) {
  for (int i = 0; i <= 30; ++i) {
    const double pixels_per_degree = std::pow(10.0, 0.1 * i);
    const FlipKernels kernels = make_flip_kernels(pixels_per_degree);
    EXPECT_NEAR(total(kernels.achromatic.across) * total(kernels.achromatic.down), 1.0, 1e-12);
    EXPECT_NEAR(total(kernels.red_green.across) * total(kernels.red_green.down), 1.0, 1e-12);
    EXPECT_NEAR(total(kernels.blue_yellow_wide.down) + total(kernels.blue_yellow_narrow.down), 1.0,
                1e-12);
    EXPECT_NEAR(total(kernels.smooth), 1.0, 1e-12);
    EXPECT_NEAR(total(kernels.point), 0.0, 1e-12) << pixels_per_degree;
    EXPECT_TRUE(kernels.edge.odd);
    double right = 0.0;
    for (const double weight : kernels.edge.right) right += weight;
    EXPECT_NEAR(right, -1.0, 1e-12) << pixels_per_degree;
  }
}

TEST(FlipColor, Greys_HaveNoHue) {
  for (const double y : {0.0, 0.001, 0.01, 0.02, 0.05, 0.18, 0.4, 0.7, 1.0}) {
    const Triple lab = to_hunt_lab(to_opponent({y, y, y}));
    const double lightness = y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 24389.0 / 27.0 * y;
    EXPECT_NEAR(lab[0], lightness, 1e-11);
    EXPECT_NEAR(lab[1], 0.0, 1e-9);
    EXPECT_NEAR(lab[2], 0.0, 1e-9);
  }
}

TEST(FlipColor, RandomColors_ErrorsInRange) {
  test::Random random(10);
  for (int i = 0; i < 1000; ++i) {
    const Triple a = {random.uniform(), random.uniform(), random.uniform()};
    const Triple b = {random.uniform(), random.uniform(), random.uniform()};
    const double error = color_error(to_hunt_lab(to_opponent(a)), to_hunt_lab(to_opponent(b)));
    EXPECT_GT(error, 0.0);
    EXPECT_LE(error, 1.0);
    EXPECT_LE(combined_error(error, 0.0), combined_error(error, 0.3));
  }
}

}  // namespace
}  // namespace lume::io
