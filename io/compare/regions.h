// SPDX-License-Identifier: Apache-2.0
// Means over tiles and over the whole image, tested with and without the pixels of fireflies.
#pragma once

#include "io/compare/smallest_p.h"
#include "io/compare/statistical_test.h"
#include "io/compare/welch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lume::io {

/// A rectangle of pixels.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Rectangles of tile_size^2 pixels, row by row; those at the right and lower edge may be smaller.
[[nodiscard]] std::vector<Region> tile_grid(int width, int height, int tile_size);

/// A pixel is a firefly's if its score, a variance, exceeds that of the tile's median pixel by this
/// factor. Half of the tile's pixels would have to be fireflies to move the median.
inline constexpr double k_firefly_factor = 100.0;

/// Scores above this are fireflies, given those of all pixels of a tile. Infinite if the median is
/// 0: there is nothing to measure with.
[[nodiscard]] double firefly_limit(std::vector<double> scores);

/// One channel of a region.
struct TestedRegion {
  Region region;
  std::size_t channel = 0;
  EstimatePair all;
  std::optional<EstimatePair> kept;  ///< without fireflies, if there are any to leave out
};

/// How to judge one region.
struct RegionRule {
  double variance_ratio = 1.0;  ///< see welch_test
  double rounding = 0.0;
};

/// True if a region's p is below what `limit` has seen.
[[nodiscard]] bool any_region_reaches(const std::vector<TestedRegion>& regions,
                                      const RegionRule& rule, SmallestP limit);

/// Tests all regions; `family` comes with its number of tests and its threshold.
void test_regions(const std::vector<TestedRegion>& regions, const RegionRule& rule,
                  const PictureShape& shape, StatisticalFamily& family);

/// Sets the detectable bias of `family`: of the `share` (0.5: the median) of its regions.
void set_detectable_bias(const std::vector<TestedRegion>& regions, const RegionRule& rule,
                         double share, StatisticalFamily& family);

}  // namespace lume::io
