// SPDX-License-Identifier: Apache-2.0
#include "io/compare/pixel_family.h"

#include "geometry/parallel.h"
#include "io/compare/finding.h"

#include <algorithm>

namespace lume::io {
namespace {

bool is_constant(const EstimatePair& pair) {
  return pair.actual.variance + pair.expected.variance == 0.0;
}

/// The mean variance of either side.
class MeanVariance {
 public:
  void add(const EstimatePair& pair) {
    actual_ += pair.actual.variance;
    expected_ += pair.expected.variance;
    count_ += 1.0;
  }
  void raise(EstimatePair& pair) const {
    pair.actual.variance = std::max(pair.actual.variance, actual_ / count_);
    pair.expected.variance = std::max(pair.expected.variance, expected_ / count_);
  }

 private:
  double actual_ = 0.0;
  double expected_ = 0.0;
  double count_ = 0.0;
};

/// The worst pixel of a tile's channel, if its p is below what `smallest` has seen.
Finding worst_pixel(const PixelTests& tests, const Region& tile, std::size_t channel,
                    SmallestP smallest) {
  std::vector<EstimatePair> pixels;
  tests.read(tile, channel, pixels);
  if (tests.doubt) doubt_constants(pixels);
  Finding worst;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const WelchTest test = welch_test(pixels[i], tests.rule.variance_ratio, tests.rule.rounding);
    if (!smallest.offer(test.t, test.degrees)) continue;
    const auto x = static_cast<int>(i) % tile.width;
    const auto y = static_cast<int>(i) / tile.width;
    worst = {{tile.x + x, tile.y + y, 1, 1}, channel, pixels[i], smallest.log_p()};
  }
  return worst;
}

}  // namespace

void doubt_constants(std::vector<EstimatePair>& pixels) {
  MeanVariance mean;
  for (const EstimatePair& pixel : pixels) mean.add(pixel);
  for (EstimatePair& pixel : pixels) {
    if (is_constant(pixel)) mean.raise(pixel);
  }
}

void doubt_constants(std::vector<TestedRegion>& tiles, const PixelTests& tests) {
  std::vector<MeanVariance> means(tests.channels);
  for (const TestedRegion& tile : tiles) means[tile.channel].add(tile.all);
  std::vector<EstimatePair> pixels;
  for (TestedRegion& tile : tiles) {
    tests.read(tile.region, tile.channel, pixels);
    if (std::all_of(pixels.begin(), pixels.end(), is_constant)) continue;
    means[tile.channel].raise(tile.all);
    tile.kept.reset();
  }
}

bool any_pixel_reaches(const PixelTests& tests, const SmallestP& limit) {
  for (const Region& tile : tests.tiles) {
    for (std::size_t channel = 0; channel < tests.channels; ++channel) {
      if (worst_pixel(tests, tile, channel, limit).log_p < 0.0) return true;
    }
  }
  return false;
}

void test_pixels(const PixelTests& tests, const PictureShape& shape, StatisticalFamily& family) {
  std::vector<Finding> findings(tests.tiles.size() * tests.channels);
  geometry::parallel_for(findings.size(), [&](std::size_t i) {
    const Region& tile = tests.tiles[i / tests.channels];
    findings[i] = worst_pixel(tests, tile, i % tests.channels, SmallestP());
  });
  const auto worst =
      std::min_element(findings.begin(), findings.end(),
                       [](const Finding& a, const Finding& b) { return a.log_p < b.log_p; });
  record(*worst, shape, family);
}

}  // namespace lume::io
