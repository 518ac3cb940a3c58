// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_hdr.h"

#include "io/compare/flip_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::io {
namespace {

/// What the brightest and the median pixel are mapped to: t of the paper.
constexpr double k_nearly_white = 0.85;

/// Finite and >= 0.
double light(float value) {
  return value > 0.0f ? std::min(value, std::numeric_limits<float>::max()) : 0.0;
}

double luminance_of(const shading::Color& c) {
  return 0.2126 * light(c.x) + 0.7152 * light(c.y) + 0.0722 * light(c.z);
}

/// The value in the middle, or the mean of both that are; reorders the values.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

FlipExposures flip_exposures(const RgbImage& reference) {
  std::vector<double> luminances(reference.pixels.size());
  std::transform(reference.pixels.begin(), reference.pixels.end(), luminances.begin(),
                 luminance_of);
  const auto brightest = std::max_element(luminances.begin(), luminances.end());
  if (brightest == luminances.end() || *brightest == 0.0) return {0.0, 0.0, 1};
  const double most = *brightest;
  double middle = median(luminances);
  if (middle == 0.0) {
    luminances.erase(std::remove(luminances.begin(), luminances.end(), 0.0), luminances.end());
    middle = median(luminances);
  }
  const double white = std::log2(inverse_tone_map_aces(k_nearly_white));
  const FlipExposures range{white - std::log2(most), white - std::log2(middle), 2};
  const double count = std::ceil(range.last - range.first);
  return {range.first, range.last,
          static_cast<int>(std::clamp(count, 2.0, static_cast<double>(k_flip_most_exposures)))};
}

HdrFlip flip_hdr(const RgbImage& reference, const RgbImage& test, const FlipOptions& options) {
  return flip_hdr(reference, test, flip_exposures(reference), options);
}

HdrFlip flip_hdr(const RgbImage& reference, const RgbImage& test, const FlipExposures& exposures,
                 const FlipOptions& options) {
  check_flip(reference, test, options);
  const FlipKernels kernels = make_flip_kernels(options.pixels_per_degree);
  HdrFlip result;
  result.exposures = exposures;
  result.error.resize(reference.pixels.size());
  result.worst.resize(reference.pixels.size());
  for (int i = 0; i < exposures.count; ++i) {
    const FlipDisplay display{true, std::exp2(exposures.stop(i))};
    const std::vector<float> errors = flip_map(reference, test, display, kernels);
    for (std::size_t p = 0; p < errors.size(); ++p) {
      if (errors[p] <= result.error[p]) continue;
      result.error[p] = errors[p];
      result.worst[p] = i;
    }
  }
  return result;
}

}  // namespace lume::io
