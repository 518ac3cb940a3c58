// SPDX-License-Identifier: Apache-2.0
#include "io/compare/metrics.h"

#include "geometry/parallel.h"

#include <algorithm>
#include <cmath>

namespace lume::io {
namespace {

/// Values that are summed in a row. Sums of such chunks are summed in their order, whoever made
/// them.
constexpr std::size_t k_chunk = 1u << 16u;

struct Sums {
  double absolute = 0.0;
  double squared = 0.0;
  double relative = 0.0;
  std::size_t outliers = 0;
  double max = 0.0;
  std::size_t worst = 0;
};

Sums sum_up(const float* actual, const float* expected, std::size_t count) {
  Sums sums;
  for (std::size_t i = 0; i < count; ++i) {
    const auto e = static_cast<double>(expected[i]);
    const double difference = std::abs(static_cast<double>(actual[i]) - e);
    sums.absolute += difference;
    sums.squared += difference * difference;
    sums.relative += difference * difference / (e * e + 0.01);
    sums.outliers += difference > std::max(std::abs(e), 0.01) / 500.0 ? 1 : 0;
    if (difference > sums.max) {
      sums.max = difference;
      sums.worst = i;
    }
  }
  return sums;
}

}  // namespace

PixelMetrics measure(std::span<const std::vector<float>* const> actual,
                     std::span<const std::vector<float>* const> expected) {
  const std::size_t length = actual[0]->size();
  const std::size_t chunks = (length + k_chunk - 1) / k_chunk;
  std::vector<Sums> parts(actual.size() * chunks);
  geometry::parallel_for(parts.size(), [&](std::size_t i) {
    const std::size_t first = i % chunks * k_chunk;
    parts[i] = sum_up(actual[i / chunks]->data() + first, expected[i / chunks]->data() + first,
                      std::min(k_chunk, length - first));
  });

  Sums all;
  PixelMetrics result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    all.absolute += parts[i].absolute;
    all.squared += parts[i].squared;
    all.relative += parts[i].relative;
    all.outliers += parts[i].outliers;
    if (parts[i].max > result.max) {
      result.max = parts[i].max;
      result.worst_plane = i / chunks;
      result.worst_index = i % chunks * k_chunk + parts[i].worst;
    }
  }
  const auto count = static_cast<double>(actual.size() * length);
  result.mae = all.absolute / count;
  result.rmse = std::sqrt(all.squared / count);
  result.relmse = all.relative / count;
  result.psnr = -20.0 * std::log10(result.rmse);
  result.outliers = static_cast<double>(all.outliers) / count;
  return result;
}

}  // namespace lume::io
