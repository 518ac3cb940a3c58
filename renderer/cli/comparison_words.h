// SPDX-License-Identifier: Apache-2.0
// What a comparison found, in words that `lume compare` and `lume test` share.
#pragma once

#include "io/compare/comparison.h"

#include <string>

namespace lume::cli {

/// A value with four digits, as reports show it.
[[nodiscard]] std::string metric_value(double value);
/// "<= 0.01"; empty without a limit.
[[nodiscard]] std::string metric_limit(const io::MetricVerdict& metric);
/// "rmse 0.0123 (<= 0.01)".
[[nodiscard]] std::string describe_metric(const io::MetricVerdict& metric);

/// Where the largest difference is; empty if there is none.
[[nodiscard]] std::string describe_worst(const io::Comparison& comparison);
/// The limits that do not hold, and the largest difference.
[[nodiscard]] std::string why_failed(const io::Comparison& comparison);

}  // namespace lume::cli
