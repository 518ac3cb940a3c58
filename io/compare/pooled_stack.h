// SPDX-License-Identifier: Apache-2.0
// The images of both stacks in one row, under any assignment to the two sides.
#pragma once

#include "io/compare/estimates.h"
#include "io/compare/label_exchange.h"
#include "io/compare/regions.h"

#include <cstddef>
#include <vector>

namespace lume::io {

/// Refers to both stacks, which must outlive it and are checked already. Values are held as
/// deviations from the mean of all images, which no assignment changes: constants are exactly 0.
class PooledStack {
 public:
  /// `robust`: look for fireflies, so that regions can be tested without them as well.
  PooledStack(const EstimateStack& actual, const EstimateStack& expected, int tile_size,
              bool robust);

  [[nodiscard]] const std::vector<Region>& tiles() const { return tiles_; }
  [[nodiscard]] std::size_t channels() const { return channels_.size(); }
  [[nodiscard]] std::size_t fireflies() const { return fireflies_; }

  /// Each channel of each tile, and of the image.
  [[nodiscard]] std::vector<TestedRegion> tile_estimates(const Labels& actual) const {
    return estimates(tile_series_, actual);
  }
  [[nodiscard]] std::vector<TestedRegion> image_estimates(const Labels& actual) const {
    return estimates(image_series_, actual);
  }

  /// The pixels of a region.
  void pixel_estimates(const Labels& actual, const Region& region, std::size_t channel,
                       std::vector<EstimatePair>& out) const;

 private:
  struct Channel {
    std::vector<double> mean;     ///< of all images, for each pixel
    std::vector<double> squares;  ///< sum of squared deviations from it
  };
  /// Sums over some pixels of a region.
  struct Series {
    double count = 0.0;
    double mean = 0.0;
    double scale = 0.0;              ///< of |mean|
    std::vector<double> deviations;  ///< of each image, from mean
    double squares = 0.0;            ///< sum of the deviations' squares
  };
  struct RegionSeries {
    Region region;
    std::size_t channel = 0;
    Series all;
    Series kept;
  };

  [[nodiscard]] const float* plane(std::size_t image, std::size_t channel) const;
  [[nodiscard]] std::size_t images() const {
    return actual_.images.size() + expected_.images.size();
  }
  void pool(std::size_t channel);
  [[nodiscard]] std::vector<std::size_t> indices(const Region& region) const;
  [[nodiscard]] Series sum(const std::vector<std::size_t>& pixels, std::size_t channel) const;
  [[nodiscard]] RegionSeries sum_tile(const Region& tile, std::size_t channel, bool robust) const;
  void sum_image();
  [[nodiscard]] std::vector<TestedRegion> estimates(const std::vector<RegionSeries>& series,
                                                    const Labels& actual) const;

  const EstimateStack& actual_;
  const EstimateStack& expected_;
  std::vector<Region> tiles_;
  std::vector<Channel> channels_;
  std::vector<RegionSeries> tile_series_;
  std::vector<RegionSeries> image_series_;
  std::size_t fireflies_ = 0;
};

}  // namespace lume::io
