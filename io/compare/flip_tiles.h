// SPDX-License-Identifier: Apache-2.0
// FLIP of whole pictures, tile by tile: what a tile needs in between stays in the cache.
#pragma once

#include "io/compare/flip.h"
#include "io/compare/flip_filters.h"

#include <vector>

namespace lume::io {

/// How linear values come to the display, where they are in [0, 1].
struct FlipDisplay {
  bool tone_mapped = false;  ///< by tone_map_aces, else clamped
  double exposure = 1.0;     ///< factor before tone mapping
};

/// Narkowicz's fit of the ACES curve for x >= 0, not clamped (Narkowicz 2015, "ACES Filmic Tone
/// Mapping Curve"), at the exposure of 0.6 that HDR-FLIP takes it with.
[[nodiscard]] double tone_map_aces(double x);

/// The x > 0 that tone_map_aces maps to y in (0, 1).
[[nodiscard]] double inverse_tone_map_aces(double y);

/// FLIP of each pixel as the display shows them. Both pictures are of one size.
[[nodiscard]] std::vector<float> flip_map(const RgbImage& reference, const RgbImage& test,
                                          const FlipDisplay& display, const FlipKernels& kernels);

/// Throws std::invalid_argument unless both are of one size and the options are in range.
void check_flip(const RgbImage& reference, const RgbImage& test, const FlipOptions& options);

}  // namespace lume::io
