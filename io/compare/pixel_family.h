// SPDX-License-Identifier: Apache-2.0
// Every pixel's own test. There may be millions, so they are computed tile by tile where needed and
// never kept.
#pragma once

#include "io/compare/regions.h"

#include <functional>
#include <vector>

namespace lume::io {

/// Fills in a channel's pixels of a region, row by row. Called from several threads.
using PixelReader =
    std::function<void(const Region& region, std::size_t channel, std::vector<EstimatePair>& out)>;

struct PixelTests {
  std::vector<Region> tiles;
  std::size_t channels = 0;
  PixelReader read;
  RegionRule rule;
  bool doubt = false;  ///< apply doubt_constants
};

/// True if a pixel's p is below what `limit` has seen.
[[nodiscard]] bool any_pixel_reaches(const PixelTests& tests, const SmallestP& limit);

/// For where labels cannot be exchanged. A pixel whose few images happen to agree on each side is
/// not certain of its value if its tile is noisy: it is taken for as noisy as the tile.
void doubt_constants(std::vector<EstimatePair>& pixels);

/// The same for tiles: one whose images happen to agree (each has one firefly, say) is taken for as
/// noisy as the channel's mean tile, unless each of its pixels is constant.
void doubt_constants(std::vector<TestedRegion>& tiles, const PixelTests& tests);

/// Tests all pixels; `family` comes with its number of tests and its threshold.
void test_pixels(const PixelTests& tests, const PictureShape& shape, StatisticalFamily& family);

}  // namespace lume::io
