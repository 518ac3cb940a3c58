// SPDX-License-Identifier: Apache-2.0
// Smaller pictures, for pages that would get too large.
#pragma once

#include "io/compare/rgb_image.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lume::io {

/// The size that a picture may have.
struct SizeLimit {
  int side = 0;  ///< the longer one
  std::size_t pixels = 0;
};

/// By which whole number a picture's sides must be divided, rounding up, to keep the limit. 1: it
/// keeps it as it is.
[[nodiscard]] int reduction_factor(int width, int height, const SizeLimit& limit);

/// Means of squares of factor * factor pixels; those at the right and lower edges may be cut off.
[[nodiscard]] RgbImage reduce(const RgbImage& image, int factor);
/// The same of a map of width * height values.
[[nodiscard]] std::vector<float> reduce(std::span<const float> values, int width, int height,
                                        int factor);

}  // namespace lume::io
