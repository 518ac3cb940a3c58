// SPDX-License-Identifier: Apache-2.0
// What the eye can resolve, as filters over pixels (Andersson and others 2020). All of them are
// products of one filter along x and one along y, or sums of two of those.
#pragma once

#include <cstddef>
#include <vector>

namespace lume::io {

/// One row of weights from -radius to radius, of which the left ones follow from the right ones.
struct Kernel {
  double center = 0.0;
  std::vector<double> right;  ///< of the pixels 1 ... radius
  bool odd = false;           ///< left weights are minus the right ones
};

/// Weights of a two-dimensional filter: across[dx] * down[dy].
struct SeparableKernel {
  Kernel across;
  Kernel down;
};

struct FlipKernels {
  // Contrast sensitivity of the three opponent channels; together, the last two are one filter.
  SeparableKernel achromatic;
  SeparableKernel red_green;
  SeparableKernel blue_yellow_wide;
  SeparableKernel blue_yellow_narrow;

  // Detectors of features: along x, of which those along y are the transposed ones.
  Kernel smooth;  ///< across the direction of the detectors
  Kernel edge;    ///< first derivative of a Gaussian
  Kernel point;   ///< second derivative

  std::size_t radius = 0;  ///< of the largest of all
};

[[nodiscard]] FlipKernels make_flip_kernels(double pixels_per_degree);

/// Values in rows.
struct Plane {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<double> values;

  void resize(std::size_t new_width, std::size_t new_height) {
    width = new_width;
    height = new_height;
    values.resize(width * height);
  }
  [[nodiscard]] double* row(std::size_t y) { return values.data() + y * width; }
  [[nodiscard]] const double* row(std::size_t y) const { return values.data() + y * width; }
};

/// Filters the rows of `in`: `out` lacks `margin` >= the kernel's radius columns on both sides.
void filter_across(const Plane& in, const Kernel& kernel, std::size_t margin, Plane& out);

/// Filters the columns of `in`: `out` lacks `margin` rows above and below.
void filter_down(const Plane& in, const Kernel& kernel, std::size_t margin, Plane& out);

}  // namespace lume::io
