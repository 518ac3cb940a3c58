// SPDX-License-Identifier: Apache-2.0
// FLIP of scene-linear pictures, at whatever exposure shows the error best: Andersson, Nilsson,
// Shirley and Akenine-Moller 2021, "Visualizing Errors in Rendered High Dynamic Range Images".
#pragma once

#include "io/compare/flip.h"

#include <vector>

namespace lume::io {

/// The exposures that HDR-FLIP looks at, in stops.
struct FlipExposures {
  double first = 0.0;
  double last = 0.0;
  int count = 2;  ///< evenly spaced, both ends included

  [[nodiscard]] double stop(int i) const {
    return count < 2 ? first : first + (last - first) * i / (count - 1);
  }
};

/// About one stop lies between two exposures, as long as these are no more than this.
inline constexpr int k_flip_most_exposures = 32;

/// From where the brightest pixel of `reference` is nearly white to where the median one is
/// (Andersson and others 2021). Black pixels only count if less than half are black, and one
/// exposure is enough if all are.
[[nodiscard]] FlipExposures flip_exposures(const RgbImage& reference);

struct HdrFlip {
  std::vector<float> error;  ///< of each pixel, in [0, 1]: the largest FLIP of all exposures
  std::vector<int> worst;    ///< of each pixel, the number of the first exposure that shows it
  FlipExposures exposures;
};

/// HDR-FLIP of two pictures of one size. Values may be negative and of any size; what is not a
/// number counts as 0. The reference alone sets the exposures.
[[nodiscard]] HdrFlip flip_hdr(const RgbImage& reference, const RgbImage& test,
                               const FlipOptions& options = {});

/// The same at given exposures.
[[nodiscard]] HdrFlip flip_hdr(const RgbImage& reference, const RgbImage& test,
                               const FlipExposures& exposures, const FlipOptions& options = {});

}  // namespace lume::io
