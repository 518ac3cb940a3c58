// SPDX-License-Identifier: Apache-2.0
// The statistical tests of one image a side, from the variances that a renderer gives with it.
#include "io/compare/families.h"
#include "io/compare/pixel_family.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lume::io {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Collects the mean of independent pixels' means.
class MeanOfPixels {
 public:
  void add(const Estimate& pixel) {
    count_ += 1.0;
    mean_ += pixel.mean;
    variance_ += pixel.variance;
    // Satterthwaite's degrees of freedom of a sum of variances, term by term.
    inverse_ += pixel.variance * pixel.variance / pixel.degrees;
  }
  [[nodiscard]] Estimate get() const {
    const double degrees = inverse_ > 0.0 ? variance_ * variance_ / inverse_ : k_infinity;
    return {mean_ / count_, variance_ / (count_ * count_), degrees};
  }

 private:
  double count_ = 0.0;
  double mean_ = 0.0;
  double variance_ = 0.0;
  double inverse_ = 0.0;
};

/// The same for both sides.
class MeanOfPairs {
 public:
  void add(const EstimatePair& pixel) {
    actual_.add(pixel.actual);
    expected_.add(pixel.expected);
    scale_ += pixel.scale;
    count_ += 1.0;
  }
  [[nodiscard]] EstimatePair get() const {
    return {actual_.get(), expected_.get(), 0.0, scale_ / count_};
  }
  [[nodiscard]] double count() const { return count_; }

 private:
  MeanOfPixels actual_;
  MeanOfPixels expected_;
  double scale_ = 0.0;
  double count_ = 0.0;
};

struct RegionSums {
  MeanOfPairs all;
  MeanOfPairs kept;

  [[nodiscard]] TestedRegion get(const Region& region, std::size_t channel) const {
    TestedRegion tested{region, channel, all.get(), std::nullopt};
    if (kept.count() < all.count()) tested.kept = kept.get();
    return tested;
  }
};

class MomentTests {
 public:
  MomentTests(const EstimateMoments& actual, const EstimateMoments& expected,
              const StatisticalSettings& settings)
      : actual_(actual),
        expected_(expected),
        settings_(settings),
        tiles_(tile_grid(actual.shape.width, actual.shape.height, settings.tile_size)) {}

  [[nodiscard]] StatisticalResult run() const {
    const PictureShape& shape = actual_.shape;
    StatisticalResult result = make_result(shape, tiles_.size(), settings_);
    std::vector<TestedRegion> tiles;
    std::vector<TestedRegion> image;
    for (std::size_t channel = 0; channel < shape.channels.size(); ++channel) {
      result.fireflies += add_channel(channel, tiles, image);
    }
    const RegionRule rule{ratio(), settings_.rounding};
    const auto read = [&](const Region& region, std::size_t channel,
                          std::vector<EstimatePair>& out) { read_pixels(region, channel, out); };
    test_pixels({tiles_, shape.channels.size(), read, rule, true}, shape, result.pixels);
    test_regions(tiles, rule, shape, result.tiles);
    test_regions(image, rule, shape, result.image);
    set_detectable_bias(tiles, rule, 0.5, result.tiles);
    set_detectable_bias(image, rule, 1.0, result.image);
    result.passed = result.pixels.passed && result.tiles.passed && result.image.passed;
    return result;
  }

 private:
  static double degrees_of(const EstimateMoments& side) {
    return side.samples == 0 ? k_infinity : static_cast<double>(side.samples - 1);
  }

  /// Of the variances, by the numbers of samples.
  [[nodiscard]] double ratio() const {
    if (actual_.samples == 0 || expected_.samples == 0) return 1.0;
    return static_cast<double>(expected_.samples) / static_cast<double>(actual_.samples);
  }

  void read_pixels(const Region& region, std::size_t channel,
                   std::vector<EstimatePair>& out) const {
    const auto estimate = [&](const EstimateMoments& side, std::size_t i) {
      return Estimate{static_cast<double>(side.mean[channel][i]),
                      static_cast<double>(side.variance[channel][i]), degrees_of(side)};
    };
    out.clear();
    for (int y = region.y; y < region.y + region.height; ++y) {
      for (int x = region.x; x < region.x + region.width; ++x) {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(actual_.shape.width) +
            static_cast<std::size_t>(x);
        const EstimatePair pair{estimate(actual_, i), estimate(expected_, i)};
        out.push_back(pair);
        out.back().scale = std::max(std::abs(pair.actual.mean), std::abs(pair.expected.mean));
      }
    }
  }

  /// Adds a channel's tiles and image; returns how many pixels are fireflies.
  std::size_t add_channel(std::size_t channel, std::vector<TestedRegion>& tiles,
                          std::vector<TestedRegion>& image) const {
    const bool robust = actual_.samples == expected_.samples;
    RegionSums whole;
    std::vector<EstimatePair> pixels;
    for (const Region& tile : tiles_) {
      read_pixels(tile, channel, pixels);
      std::vector<double> scores(pixels.size());
      std::transform(pixels.begin(), pixels.end(), scores.begin(), [](const EstimatePair& pixel) {
        return pixel.actual.variance + pixel.expected.variance;
      });
      const double limit = robust ? firefly_limit(scores) : k_infinity;
      RegionSums sums;
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (RegionSums* to : {&sums, &whole}) {
          to->all.add(pixels[i]);
          if (scores[i] <= limit) to->kept.add(pixels[i]);
        }
      }
      tiles.push_back(sums.get(tile, channel));
    }
    image.push_back(whole.get({0, 0, actual_.shape.width, actual_.shape.height}, channel));
    return static_cast<std::size_t>(whole.all.count() - whole.kept.count());
  }

  const EstimateMoments& actual_;
  const EstimateMoments& expected_;
  StatisticalSettings settings_;
  std::vector<Region> tiles_;
};

void check_moments(const EstimateMoments& moments) {
  check_planes(moments.mean, moments.shape);
  check_planes(moments.variance, moments.shape);
  for (const std::vector<float>& plane : moments.variance) {
    if (std::any_of(plane.begin(), plane.end(), [](float v) { return v < 0.0f; })) {
      throw std::invalid_argument("a variance is negative, expected at least 0");
    }
  }
  if (moments.samples < 0 || moments.samples == 1) {
    throw std::invalid_argument("a variance of less than 2 samples, expected at least 2");
  }
}

}  // namespace

StatisticalResult test_moments(const EstimateMoments& actual, const EstimateMoments& expected,
                               const StatisticalSettings& settings) {
  check_shapes(actual.shape, expected.shape, settings);
  check_moments(actual);
  check_moments(expected);
  return MomentTests(actual, expected, settings).run();
}

}  // namespace lume::io
