// SPDX-License-Identifier: Apache-2.0
// How far numbers are from those that were expected, without asking what they stand for.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lume::io {

/// Over all values of all planes. Sums do not depend on the number of threads.
struct PixelMetrics {
  double max = 0.0;     ///< largest |a - e|
  double mae = 0.0;     ///< mean of |a - e|
  double rmse = 0.0;    ///< root of the mean of (a - e)^2
  double relmse = 0.0;  ///< mean of (a - e)^2 / (e^2 + 0.01) (Rousselle, Knaus and Zwicker 2011)
  double psnr = 0.0;    ///< dB, 20 log10(1 / rmse): 1 is the peak; infinite for equal values
  /// Share of the values further from e than a 500th of |e|, or of 0.01 where |e| is less.
  double outliers = 0.0;
  std::size_t worst_plane = 0;  ///< where the largest difference is first met
  std::size_t worst_index = 0;
};

/// Planes of both sides in the same order and of the same, positive length.
[[nodiscard]] PixelMetrics measure(std::span<const std::vector<float>* const> actual,
                                   std::span<const std::vector<float>* const> expected);

}  // namespace lume::io
