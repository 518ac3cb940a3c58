// SPDX-License-Identifier: Apache-2.0
// A FLIP map in a few numbers.
#pragma once

#include "io/compare/flip.h"

#include <span>

namespace lume::io {

/// The pooled values of Andersson and others 2020. Quantiles are weighted by the errors
/// themselves: half of all error is in pixels with more than the weighted median.
struct FlipSummary {
  double mean = 0.0;
  double weighted_median = 0.0;
  double first_weighted_quartile = 0.0;
  double third_weighted_quartile = 0.0;
  double min = 0.0;
  double max = 0.0;
};

/// Of errors >= 0, all 0 if there are none. Does not depend on their order.
[[nodiscard]] FlipSummary summarize_flip(std::span<const float> errors);

}  // namespace lume::io
