// SPDX-License-Identifier: Apache-2.0
// Small pictures that tests of FLIP compare.
#pragma once

#include "io/compare/rgb_image.h"
#include "tests/support/random.h"

#include <cmath>
#include <cstddef>

namespace lume::tests {

template <typename ColorAt>
io::RgbImage make_picture(int width, int height, const ColorAt& color_at) {
  io::RgbImage image{width, height, {}};
  image.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.push_back(color_at(x, y));
  }
  return image;
}

inline io::RgbImage flat_picture(const shading::Color& color, int width = 7, int height = 5) {
  return make_picture(width, height, [&](int, int) { return color; });
}

/// Independent colours in [0, most].
inline io::RgbImage noise_picture(int width, int height, unsigned seed, float most = 1.0f) {
  test::Random random(seed);
  return make_picture(width, height,
                      [&](int, int) { return 0.5f * most + random.cube(0.5f * most); });
}

/// A colour ramp with a bright disk, a dark bar and single bright pixels, moved by (x, y).
inline io::RgbImage scene_picture(int width, int height, int move_x, int move_y) {
  return make_picture(width, height, [=](int at_x, int at_y) {
    const int x = at_x - move_x;
    const int y = at_y - move_y;
    const auto u = static_cast<float>(x) / static_cast<float>(width);
    const auto v = static_cast<float>(y) / static_cast<float>(height);
    if (x % 11 == 3 && y % 13 == 5) return shading::Color(1.0f, 1.0f, 0.9f);
    if (std::abs(u - 0.7f) < 0.05f) return shading::Color(0.02f, 0.0f, 0.05f);
    if (std::hypot(u - 0.3f, v - 0.4f) < 0.2f) return shading::Color(0.9f, 0.3f, 0.1f);
    return shading::Color(0.2f + 0.3f * u, 0.5f * v, 0.4f - 0.3f * u);
  });
}

}  // namespace lume::tests
