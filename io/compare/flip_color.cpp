// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_color.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace lume::io {
namespace {

using Matrix = std::array<Triple, 3>;

// The constants of the paper, by its names.
constexpr double k_color_exponent = 0.7;  // q_c
constexpr double k_knee_in = 0.4;         // p_c: the share of c_max ...
constexpr double k_knee_out = 0.95;       // p_t: ... that is mapped to this

constexpr Triple multiply(const Matrix& m, const Triple& v) {
  return {m[0][0] * v[0] + m[0][1] * v[1] + m[0][2] * v[2],
          m[1][0] * v[0] + m[1][1] * v[1] + m[1][2] * v[2],
          m[2][0] * v[0] + m[2][1] * v[1] + m[2][2] * v[2]};
}

/// Linear sRGB to XYZ in exact fractions of the chromaticities of ITU-R BT.709 and D65 at
/// (0.3127, 0.3290); each row over its sum, so that white is (1, 1, 1).
constexpr Matrix k_from_rgb = {
    {{10135552.0 / 23359437.0, 8788810.0 / 23359437.0, 4435075.0 / 23359437.0},
     {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
     {1425312.0 / 80288307.0, 8788810.0 / 80288307.0, 70074185.0 / 80288307.0}}};

constexpr Matrix inverse(const Matrix& m) {
  Matrix result{};
  double determinant = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3;
      const std::size_t s = (j + 2) % 3;
      const std::size_t c = (i + 1) % 3;
      const std::size_t d = (i + 2) % 3;
      result[i][j] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
    }
    determinant += result[i][0] * m[0][i];
  }
  for (Triple& row : result) {
    for (double& value : row) value /= determinant;
  }
  return result;
}

constexpr Matrix k_to_rgb = inverse(k_from_rgb);

/// Of t > 0. A third of the exponent, which is right to 4%, and two of Halley's steps, which cube
/// the error: several times as fast as std::cbrt, and right to 1e-14.
double cube_root(double t) {
  constexpr std::uint64_t k_two_thirds_of_bias = 0x2A9F789300000000;
  auto root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(t) / 3 + k_two_thirds_of_bias);
  for (int step = 0; step < 2; ++step) {
    const double cube = root * root * root;
    root *= (cube + 2.0 * t) / (2.0 * cube + t);
  }
  return root;
}

/// The compression of L*a*b* (CIE 15:2004).
double lab_curve(double t) {
  constexpr double k_delta = 6.0 / 29.0;
  return t > k_delta * k_delta * k_delta ? cube_root(t)
                                         : t / (3.0 * k_delta * k_delta) + 4.0 / 29.0;
}

/// HyAB (Abasi, Amani Tehran and Fairchild 2020) to the power q_c.
double powered_distance(const Triple& a, const Triple& b) {
  const double da = a[1] - b[1];
  const double db = a[2] - b[2];
  return std::pow(std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db), k_color_exponent);
}

}  // namespace

Triple to_opponent(const Triple& linear_rgb) {
  const Triple xyz = multiply(k_from_rgb, linear_rgb);
  return {xyz[1], xyz[0] - xyz[1], xyz[1] - xyz[2]};
}

Triple to_hunt_lab(const Triple& opponent) {
  const double y = opponent[0];
  Triple rgb = multiply(k_to_rgb, {y + opponent[1], y, y - opponent[2]});
  for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
  Triple xyz = multiply(k_from_rgb, rgb);
  for (double& value : xyz) value = lab_curve(value);
  const double lightness = 116.0 * xyz[1] - 16.0;
  const double hunt = 0.01 * lightness;
  return {lightness, hunt * 500.0 * (xyz[0] - xyz[1]), hunt * 200.0 * (xyz[1] - xyz[2])};
}

double color_error(const Triple& reference, const Triple& test) {
  if (reference == test) return 0.0;
  static const double k_largest = largest_color_distance();
  static const double k_knee = k_knee_in * k_largest;
  const double distance = powered_distance(reference, test);
  if (distance < k_knee) return k_knee_out / k_knee * distance;
  const double above = (distance - k_knee) / (k_largest - k_knee);
  return std::min(k_knee_out + above * (1.0 - k_knee_out), 1.0);
}

double combined_error(double color, double features) {
  if (color == 0.0) return 0.0;
  return std::pow(color, std::max(1.0 - features, 0.0));
}

double largest_color_distance() {
  return powered_distance(to_hunt_lab(to_opponent({0.0, 1.0, 0.0})),
                          to_hunt_lab(to_opponent({0.0, 0.0, 1.0})));
}

}  // namespace lume::io
