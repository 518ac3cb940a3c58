// SPDX-License-Identifier: Apache-2.0
#include "io/compare/ssim.h"

#include "geometry/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace lume::io {
namespace {

constexpr int k_radius = 5;
constexpr double k_deviation = 1.5;
// (K L)^2 with K1 = 0.01, K2 = 0.03 and the range L = 1 (section III-B).
constexpr double k_c1 = 0.01 * 0.01;
constexpr double k_c2 = 0.03 * 0.03;

using Plane = std::vector<double>;
/// Of one pixel, before and after the window: both lumas, their squares and their product.
constexpr std::size_t k_moments = 5;

double encoded(float linear) {
  const double c = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;  // IEC 61966-2-1
}

double luma(const shading::Color& c) {
  return 0.2126 * encoded(c.x) + 0.7152 * encoded(c.y) + 0.0722 * encoded(c.z);
}

std::array<double, 2 * k_radius + 1> window() {
  std::array<double, 2 * k_radius + 1> weights{};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double distance = (static_cast<double>(k) - k_radius) / k_deviation;
    weights[k] = std::exp(-0.5 * distance * distance);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The place that i is a mirror image of: -1 is 0, -2 is 1, `size` is size - 1 ...
std::size_t mirrored(int i, int size) {
  const int period = 2 * size;
  const int inside = ((i % period) + period) % period;
  return static_cast<std::size_t>(inside < size ? inside : period - 1 - inside);
}

/// Equation 13, of the weighted means of a, e, aa, ee and ae.
double similarity(const std::array<double, k_moments>& m) {
  const auto [a, e, aa, ee, ae] = m;
  return (2.0 * a * e + k_c1) * (2.0 * (ae - a * e) + k_c2) /
         ((a * a + e * e + k_c1) * (aa - a * a + ee - e * e + k_c2));
}

}  // namespace

double ssim(const RgbImage& actual, const RgbImage& expected) {
  const auto width = static_cast<std::size_t>(actual.width);
  const auto height = static_cast<std::size_t>(actual.height);
  const auto weights = window();
  std::array<Plane, k_moments> across;  // each row under the window, along x
  for (Plane& plane : across) plane.resize(width * height);
  geometry::parallel_for(height, [&](std::size_t y) {
    std::vector<double> a(width);
    std::vector<double> e(width);
    for (std::size_t x = 0; x < width; ++x) {
      a[x] = luma(actual.pixels[y * width + x]);
      e[x] = luma(expected.pixels[y * width + x]);
    }
    for (std::size_t x = 0; x < width; ++x) {
      std::array<double, k_moments> sum{};
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const std::size_t at = mirrored(static_cast<int>(x + k) - k_radius, actual.width);
        const std::array<double, k_moments> moments = {a[at], e[at], a[at] * a[at], e[at] * e[at],
                                                       a[at] * e[at]};
        for (std::size_t m = 0; m < k_moments; ++m) sum[m] += weights[k] * moments[m];
      }
      for (std::size_t m = 0; m < k_moments; ++m) across[m][y * width + x] = sum[m];
    }
  });

  Plane rows(height);
  geometry::parallel_for(height, [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::array<double, k_moments> sum{};
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const std::size_t at =
            mirrored(static_cast<int>(y + k) - k_radius, actual.height) * width + x;
        for (std::size_t m = 0; m < k_moments; ++m) sum[m] += weights[k] * across[m][at];
      }
      rows[y] += similarity(sum);
    }
  });
  return std::accumulate(rows.begin(), rows.end(), 0.0) / static_cast<double>(width * height);
}

}  // namespace lume::io
