// SPDX-License-Identifier: Apache-2.0
#include "io/compare/pooled_stack.h"

#include "geometry/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lume::io {
namespace {

/// Below this share of the sum of squares, what is left of it is rounding.
constexpr double k_rounding = 1e-12;

/// Some values of which the mean of all was taken off, seen as two groups.
struct Deviations {
  double total_squares = 0.0;
  double sum = 0.0;      ///< of the first group; that of the second is the negative of it
  double squares = 0.0;  ///< of the first group

  void add(double deviation) {
    sum += deviation;
    squares += deviation * deviation;
  }

  /// The mean of one group of `count` values.
  [[nodiscard]] Estimate estimate(bool first, double count) const {
    const double raw = first ? squares : total_squares - squares;
    const double spread = raw - sum * sum / count;
    const double within = spread > k_rounding * total_squares ? spread : 0.0;
    return {(first ? sum : -sum) / count, within / (count * (count - 1.0)), count - 1.0};
  }
};

double sum_of_squares(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

}  // namespace

PooledStack::PooledStack(const EstimateStack& actual, const EstimateStack& expected, int tile_size,
                         bool robust)
    : actual_(actual),
      expected_(expected),
      tiles_(tile_grid(actual.shape.width, actual.shape.height, tile_size)),
      channels_(actual.shape.channels.size()),
      tile_series_(tiles_.size() * channels_.size()) {
  geometry::parallel_for(channels_.size(), [&](std::size_t channel) { pool(channel); });
  geometry::parallel_for(tile_series_.size(), [&](std::size_t i) {
    tile_series_[i] = sum_tile(tiles_[i / channels()], i % channels(), robust);
  });
  sum_image();
}

const float* PooledStack::plane(std::size_t image, std::size_t channel) const {
  const std::size_t first_expected = actual_.images.size();
  return image < first_expected ? actual_.images[image][channel].data()
                                : expected_.images[image - first_expected][channel].data();
}

void PooledStack::pool(std::size_t channel) {
  Channel& pooled = channels_[channel];
  const std::size_t pixels = actual_.images.front()[channel].size();
  pooled.mean.assign(pixels, 0.0);
  pooled.squares.assign(pixels, 0.0);
  for (std::size_t k = 0; k < images(); ++k) {
    const float* values = plane(k, channel);
    for (std::size_t i = 0; i < pixels; ++i) pooled.mean[i] += static_cast<double>(values[i]);
  }
  const auto count = static_cast<double>(images());
  for (double& mean : pooled.mean) mean /= count;
  for (std::size_t k = 0; k < images(); ++k) {
    const float* values = plane(k, channel);
    for (std::size_t i = 0; i < pixels; ++i) {
      const double deviation = static_cast<double>(values[i]) - pooled.mean[i];
      pooled.squares[i] += deviation * deviation;
    }
  }
}

std::vector<std::size_t> PooledStack::indices(const Region& region) const {
  std::vector<std::size_t> result;
  result.reserve(region.size());
  for (int y = region.y; y < region.y + region.height; ++y) {
    for (int x = region.x; x < region.x + region.width; ++x) {
      result.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(actual_.shape.width) +
                       static_cast<std::size_t>(x));
    }
  }
  return result;
}

PooledStack::Series PooledStack::sum(const std::vector<std::size_t>& pixels,
                                     std::size_t channel) const {
  const Channel& pooled = channels_[channel];
  Series series;
  series.count = static_cast<double>(pixels.size());
  for (const std::size_t i : pixels) {
    series.mean += pooled.mean[i];
    series.scale += std::abs(pooled.mean[i]);
  }
  series.deviations.resize(images());
  for (std::size_t k = 0; k < images(); ++k) {
    const float* values = plane(k, channel);
    for (const std::size_t i : pixels) {
      series.deviations[k] += static_cast<double>(values[i]) - pooled.mean[i];
    }
  }
  series.squares = sum_of_squares(series.deviations);
  return series;
}

PooledStack::RegionSeries PooledStack::sum_tile(const Region& tile, std::size_t channel,
                                                bool robust) const {
  std::vector<std::size_t> pixels = indices(tile);
  RegionSeries result{tile, channel, sum(pixels, channel), {}};
  if (robust) {
    std::vector<double> scores(pixels.size());
    std::transform(pixels.begin(), pixels.end(), scores.begin(),
                   [&](std::size_t i) { return channels_[channel].squares[i]; });
    const double limit = firefly_limit(scores);
    pixels.erase(
        std::remove_if(pixels.begin(), pixels.end(),
                       [&](std::size_t i) { return channels_[channel].squares[i] > limit; }),
        pixels.end());
  }
  result.kept =
      static_cast<double>(pixels.size()) < result.all.count ? sum(pixels, channel) : result.all;
  return result;
}

void PooledStack::sum_image() {
  const Region image{0, 0, actual_.shape.width, actual_.shape.height};
  const auto add = [](Series& to, const Series& from) {
    to.count += from.count;
    to.mean += from.mean;
    to.scale += from.scale;
    to.deviations.resize(from.deviations.size());
    for (std::size_t k = 0; k < from.deviations.size(); ++k) {
      to.deviations[k] += from.deviations[k];
    }
  };
  image_series_.resize(channels());
  for (std::size_t i = 0; i < tile_series_.size(); ++i) {
    RegionSeries& sums = image_series_[i % channels()];
    sums.region = image;
    sums.channel = i % channels();
    add(sums.all, tile_series_[i].all);
    add(sums.kept, tile_series_[i].kept);
  }
  for (RegionSeries& sums : image_series_) {
    sums.all.squares = sum_of_squares(sums.all.deviations);
    sums.kept.squares = sum_of_squares(sums.kept.deviations);
    fireflies_ += static_cast<std::size_t>(sums.all.count - sums.kept.count);
  }
}

std::vector<TestedRegion> PooledStack::estimates(const std::vector<RegionSeries>& series,
                                                 const Labels& actual) const {
  const auto count = static_cast<double>(actual.size());
  const double others = static_cast<double>(images()) - count;
  const auto pair_of = [&](const Series& sums) {
    Deviations groups{sums.squares};
    for (const std::uint32_t k : actual) groups.add(sums.deviations[k]);
    return scaled(
        {groups.estimate(true, count), groups.estimate(false, others), sums.mean, sums.scale},
        1.0 / sums.count);
  };
  std::vector<TestedRegion> result;
  result.reserve(series.size());
  for (const RegionSeries& sums : series) {
    result.push_back({sums.region, sums.channel, pair_of(sums.all), std::nullopt});
    if (sums.kept.count < sums.all.count) result.back().kept = pair_of(sums.kept);
  }
  return result;
}

void PooledStack::pixel_estimates(const Labels& actual, const Region& region, std::size_t channel,
                                  std::vector<EstimatePair>& out) const {
  const std::vector<std::size_t> pixels = indices(region);
  const Channel& pooled = channels_[channel];
  std::vector<Deviations> groups(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    groups[i].total_squares = pooled.squares[pixels[i]];
  }
  for (const std::uint32_t k : actual) {
    const float* values = plane(k, channel);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      groups[i].add(static_cast<double>(values[pixels[i]]) - pooled.mean[pixels[i]]);
    }
  }
  const auto count = static_cast<double>(actual.size());
  const double others = static_cast<double>(images()) - count;
  out.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double mean = pooled.mean[pixels[i]];
    out[i] = {groups[i].estimate(true, count), groups[i].estimate(false, others), mean,
              std::abs(mean)};
  }
}

}  // namespace lume::io
