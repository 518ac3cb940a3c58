// SPDX-License-Identifier: Apache-2.0
// Every analytic surface looks like a fine mesh of itself, but for its outline.
#include "tests/images/own_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lume::tests {
namespace {

using renderer::Film;

constexpr int k_width = 480;
constexpr int k_height = 270;

std::size_t pixel_index(int x, int y) {
  return static_cast<std::size_t>(y) * k_width + static_cast<std::size_t>(x);
}

/// Whether one and the same thing is seen all around the pixel.
bool is_inside(const Film& film, int x, int y) {
  constexpr int k_reach = 2;
  const std::vector<float>& instances = film.layers[0].values;
  for (int j = std::max(y - k_reach, 0); j <= std::min(y + k_reach, k_height - 1); ++j) {
    for (int i = std::max(x - k_reach, 0); i <= std::min(x + k_reach, k_width - 1); ++i) {
      if (instances[pixel_index(i, j)] != instances[pixel_index(x, y)]) return false;
    }
  }
  return true;
}

/// The largest difference of two pixels' channels, as part of the brighter one.
float difference(const shading::Vec4& a, const shading::Vec4& b) {
  float largest = 0.0f;
  for (int c = 0; c < 3; ++c) {
    largest = std::max(largest, std::abs(a[c] - b[c]) / std::max({a[c], b[c], 0.01f}));
  }
  return largest;
}

TEST(Museum, ShapesAndTheirMeshes_DifferAtOutlinesOnly) {
  Shot shot;
  shot.width = k_width;
  shot.height = k_height;
  shot.spp = 4;
  shot.aovs = {renderer::Aov::instance};
  const Film shapes = render_own_scene("museum", shot).film;
  shot.tessellated = true;
  const Film meshes = render_own_scene("museum", shot).film;

  int inside = 0;
  int differ_inside = 0;
  int differ_at_outlines = 0;
  double sum_inside = 0.0;
  for (int y = 0; y < k_height; ++y) {
    for (int x = 0; x < k_width; ++x) {
      const std::size_t pixel = pixel_index(x, y);
      const float unlike = difference(shapes.pixels[pixel], meshes.pixels[pixel]);
      if (is_inside(shapes, x, y) && is_inside(meshes, x, y)) {
        ++inside;
        sum_inside += static_cast<double>(unlike);
        differ_inside += unlike > 0.05f ? 1 : 0;
      } else {
        differ_at_outlines += unlike > 0.05f ? 1 : 0;
      }
    }
  }
  ASSERT_GT(inside, k_width * k_height / 2);
  // What is left inside are the outlines of shadows and highlights, and of the two sheets or holes
  // that one and the same thing shows behind each other.
  EXPECT_LT(differ_inside, inside / 200);
  EXPECT_LT(sum_inside / inside, 0.002);
  EXPECT_GT(differ_at_outlines, 100);  // or the same thing was rendered twice
}

}  // namespace
}  // namespace lume::tests
