// SPDX-License-Identifier: Apache-2.0
// Whether two renderings of a picture can have the same expectation. Both are noisy, each with a
// variance of its own, so means are compared by Welch's test: of every pixel, of tiles, which see
// what is too faint for a pixel, and of the whole image, which sees what is too faint for a tile.
// See docs/choosing_a_tier.md for the assumptions and the measured rates.
#pragma once

#include "io/compare/estimates.h"

#include <cstddef>
#include <optional>
#include <string>

namespace lume::io {

struct StatisticalSettings {
  /// How often equal expectations may fail, over all tests together.
  double significance = 0.01;
  int tile_size = 16;  ///< pixels
  /// A difference up to this share of the value is rounding. 2^-11 if a side was stored as half.
  double rounding = 1e-6;
};

/// Pixels, tiles or the whole image, every channel of each being one test.
struct StatisticalFamily {
  std::size_t tests = 0;
  double threshold = 0.0;       ///< of one test's p, corrected for all tests of all families
  double log_threshold = 0.0;   ///< its natural logarithm
  double smallest_log_p = 0.0;  ///< of the worst test; as p it may be too small for a double
  /// For a failure: share of relabelled stacks that look as bad; absent if that cannot be asked.
  std::optional<double> exchange_p;
  bool passed = true;

  // The worst test: in the channel, the region from (x, y) on.
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  std::string channel;
  bool without_fireflies = false;  ///< fireflies hid what the other pixels of the region showed
  double difference = 0.0;         ///< actual - expected
  /// Difference / |expected|; infinite where nothing was expected.
  double relative_difference = 0.0;

  /// Relative bias that would have been found with a probability of 95%: of the median tile, of the
  /// image's worst channel. Absent for pixels, and where all is black.
  std::optional<double> detectable_bias;

  [[nodiscard]] double smallest_p() const;
};

struct StatisticalResult {
  bool passed = true;
  double significance = 0.0;
  StatisticalFamily pixels;
  StatisticalFamily tiles;
  StatisticalFamily image;
  std::size_t fireflies = 0;  ///< pixels and channels that the robust tests leave out
};

/// Both stacks hold at least two images of one size, with the same channels; throws
/// std::invalid_argument if not. With six images or more on both sides (or 23 against 2), a
/// significance of 0.01 holds for whatever distributions that are the same on both sides; with
/// fewer it rests on means being nearly normal. Where `samples` differ, fireflies cannot be told
/// from noise without bias, and no test leaves them out.
[[nodiscard]] StatisticalResult test_stacks(const EstimateStack& actual,
                                            const EstimateStack& expected,
                                            const StatisticalSettings& settings = {});

/// The same for variances that a renderer gives, with pixels that are independent of each other.
[[nodiscard]] StatisticalResult test_moments(const EstimateMoments& actual,
                                             const EstimateMoments& expected,
                                             const StatisticalSettings& settings = {});

/// One line: "would have seen a bias of 0.4% of the whole image or 1.8% of the median tile"
/// or what failed where.
[[nodiscard]] std::string describe(const StatisticalResult& result);

}  // namespace lume::io
