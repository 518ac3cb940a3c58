// SPDX-License-Identifier: Apache-2.0
#include "io/compare/ssim.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lume::io {
namespace {

RgbImage filled(int width, int height, const shading::Color& color) {
  return {width, height,
          std::vector<shading::Color>(static_cast<std::size_t>(width * height), color)};
}

double encode(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// Luma of the pixel, taken from the other side of the border where there is none.
double luma(const RgbImage& image, int x, int y) {
  while (x < 0 || x >= image.width) x = x < 0 ? -1 - x : 2 * image.width - 1 - x;
  while (y < 0 || y >= image.height) y = y < 0 ? -1 - y : 2 * image.height - 1 - y;
  const shading::Color c = clamp(image.at(x, y), 0.0f, 1.0f);
  return 0.2126 * encode(static_cast<double>(c.x)) + 0.7152 * encode(static_cast<double>(c.y)) +
         0.0722 * encode(static_cast<double>(c.z));
}

/// The paper's sums over the two-dimensional window, pixel by pixel.
double plain_ssim(const RgbImage& a, const RgbImage& b) {
  double total = 0.0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double weight = 0.0;
      double ma = 0.0;
      double mb = 0.0;
      for (int v = -5; v <= 5; ++v) {
        for (int u = -5; u <= 5; ++u) {
          const double w = std::exp(-(u * u + v * v) / (2 * 1.5 * 1.5));
          weight += w;
          ma += w * luma(a, x + u, y + v);
          mb += w * luma(b, x + u, y + v);
        }
      }
      ma /= weight;
      mb /= weight;
      double vaa = 0.0;
      double vbb = 0.0;
      double vab = 0.0;
      for (int v = -5; v <= 5; ++v) {
        for (int u = -5; u <= 5; ++u) {
          const double w = std::exp(-(u * u + v * v) / (2 * 1.5 * 1.5)) / weight;
          const double da = luma(a, x + u, y + v) - ma;
          const double db = luma(b, x + u, y + v) - mb;
          vaa += w * da * da;
          vbb += w * db * db;
          vab += w * da * db;
        }
      }
      total += (2 * ma * mb + 1e-4) * (2 * vab + 9e-4) /
               ((ma * ma + mb * mb + 1e-4) * (vaa + vbb + 9e-4));
    }
  }
  return total / (a.width * a.height);
}

TEST(Ssim, EqualImages_AreOne) {
  test::Random random(1);
  RgbImage image = filled(20, 14, {});
  for (shading::Color& pixel : image.pixels) pixel = random.cube(2.0f);
  EXPECT_DOUBLE_EQ(ssim(image, image), 1.0);
}

TEST(Ssim, FlatImages_AreComparedByTheirLuma) {
  const double a = encode(0.25);
  const double b = encode(0.5);
  EXPECT_NEAR(ssim(filled(9, 7, shading::Color(0.25f)), filled(9, 7, shading::Color(0.5f))),
              (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-10);
}

TEST(Ssim, RandomImages_AgreeWithThePlainSums) {
  test::Random random(2);
  for (int round = 0; round < 12; ++round) {
    const int width = 1 + static_cast<int>(random.below(24));
    const int height = 1 + static_cast<int>(random.below(24));
    RgbImage a = filled(width, height, {});
    RgbImage b = a;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      a.pixels[i] = random.cube(1.0f) + 0.5f;
      b.pixels[i] = a.pixels[i] + random.cube(0.3f);
    }
    EXPECT_NEAR(ssim(a, b), plain_ssim(a, b), 1e-9) << width << "x" << height;
    EXPECT_DOUBLE_EQ(ssim(a, b), ssim(b, a));
  }
}

}  // namespace
}  // namespace lume::io
