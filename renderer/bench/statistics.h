// SPDX-License-Identifier: Apache-2.0
// What can be said of a few repeated measurements without believing that they are normally
// distributed: times on a shared machine are not, their tail is long on one side.
#pragma once

#include <cstddef>
#include <vector>

namespace lume::renderer {

/// A median, and the interval in which the median of ever more measurements lies with 95%
/// confidence (with less where there are fewer than six; see confidence_of).
struct Estimate {
  double median = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// 0 for no values; the mean of the middle two where their number is even.
[[nodiscard]] double median(std::vector<double> values);

/// The interval ends at two of the values themselves: number k from below and number k from above,
/// k as large as 95% allow. The median of what is measured lies outside with probability
/// 2 P(X < k), X binomial of n and 1/2, whatever the distribution (David and Nagaraja 2003, "Order
/// Statistics", 3rd ed., section 7.1).
[[nodiscard]] Estimate estimate_median(std::vector<double> values);

/// How many of n sorted values to leave out at either end for the interval of 95%.
[[nodiscard]] std::size_t trimmed_at_ends(std::size_t n);
/// The confidence of that interval: at least 0.95 from six values on, 1 - 2^(1 - n) below, where
/// all values together do not reach it.
[[nodiscard]] double confidence_of(std::size_t n);

}  // namespace lume::renderer
