// SPDX-License-Identifier: Apache-2.0
// How finely a scene must be divided to have a given number of triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lume::generator {

/// About the largest detail in [1, 10^4] of which count_at(detail) is at most `triangles`, or 1.
/// count_at must grow with detail, but need not do so smoothly.
template <class CountAt>
[[nodiscard]] double fit_detail(std::size_t triangles, const CountAt& count_at) {
  double low = 0.0;  // logarithms: what counts is the ratio
  double high = std::log(1e4);
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (low + high);
    (count_at(std::exp(middle)) <= triangles ? low : high) = middle;
  }
  return std::exp(low);
}

/// A number of segments that is `base` at detail 1 and grows with a power of it, up to `most`.
[[nodiscard]] inline std::uint32_t segments_at(double base, double detail, double power,
                                               double most = 1e6) {
  return static_cast<std::uint32_t>(std::min(base * std::pow(detail, power), most));
}

}  // namespace lume::generator
