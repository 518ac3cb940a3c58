// SPDX-License-Identifier: Apache-2.0
// Drawing from tabulated densities by inverting their cumulative sums; a guide table leads to the
// right cell in a step or two whatever their number (Chen and Asau 1974, the "index table" method).
#pragma once

#include "geometry/math.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lume::shading {

/// Piecewise constant on n equal cells of [0, 1). All-zero weights count as equal weights.
class Distribution1D {
 public:
  explicit Distribution1D(std::span<const float> weights);

  struct Sample {
    std::size_t cell = 0;
    float position = 0.0f;     ///< in [0, 1), over all cells
    float probability = 0.0f;  ///< of the cell; the density is probability * size()
  };
  [[nodiscard]] Sample sample(float random) const;
  [[nodiscard]] float probability(std::size_t cell) const;
  [[nodiscard]] std::size_t size() const { return cumulative_.size() - 1; }
  [[nodiscard]] double total() const { return total_; }  ///< of the weights

 private:
  std::vector<float> cumulative_;     ///< from 0 to 1, size() + 1 of them
  std::vector<std::uint32_t> guide_;  ///< for i / size(), 0 <= i < size(): the cell it lies in
  double total_ = 0.0;
};

/// Piecewise constant on the width x height equal cells of [0, 1)^2, row by row.
class Distribution2D {
 public:
  Distribution2D(int width, int height, std::span<const float> weights);

  struct Sample {
    geometry::Vec2 position{0.0f};  ///< in [0, 1)^2
    float pdf = 0.0f;               ///< over the unit square
  };
  [[nodiscard]] Sample sample(geometry::Vec2 random) const;
  [[nodiscard]] float pdf(geometry::Vec2 position) const;

 private:
  std::vector<Distribution1D> rows_;
  Distribution1D row_choice_;
};

}  // namespace lume::shading
