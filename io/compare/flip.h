// SPDX-License-Identifier: Apache-2.0
// What people notice when they flip between two pictures in place: Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom and Fairchild 2020, "FLIP: A Difference Evaluator for
// Alternating Images".
#pragma once

#include "io/compare/rgb_image.h"

#include <vector>

namespace lume::io {

/// A monitor 0.7 m wide with 3840 pixels, seen from 0.7 m, as the authors take for granted:
/// 0.7 * 3840 / 0.7 * pi / 180.
inline constexpr double k_flip_pixels_per_degree = 67.020643276582255;

/// From where one pixel covers a degree to where a degree covers a thousand pixels.
inline constexpr double k_flip_least_pixels_per_degree = 1.0;
inline constexpr double k_flip_most_pixels_per_degree = 1000.0;

struct FlipOptions {
  double pixels_per_degree = k_flip_pixels_per_degree;  ///< of visual angle
};

/// FLIP of each pixel, in [0, 1]: 0 for equal pictures, 1 for the largest difference there is.
/// Values are clamped to [0, 1]; what is not a number counts as 0. Beyond the border the pictures
/// go on with the pixels of their edge. It does not matter which picture is which. Throws
/// std::invalid_argument if sizes differ or pixels_per_degree is out of range.
[[nodiscard]] std::vector<float> flip(const RgbImage& reference, const RgbImage& test,
                                      const FlipOptions& options = {});

}  // namespace lume::io
