// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/comparison_words.h"

#include <fmt/format.h>

namespace lume::cli {
namespace {

/// The group whose largest difference is the largest.
const io::GroupComparison* worst_group(const io::Comparison& comparison) {
  const io::GroupComparison* worst = nullptr;
  for (const io::GroupComparison& group : comparison.groups) {
    if (worst == nullptr || group.metrics.max > worst->metrics.max) worst = &group;
  }
  return worst;
}

}  // namespace

std::string metric_value(double value) { return fmt::format("{:.4g}", value); }

std::string metric_limit(const io::MetricVerdict& metric) {
  if (!metric.limit) return "";
  return (metric.at_least ? ">= " : "<= ") + metric_value(*metric.limit);
}

std::string describe_metric(const io::MetricVerdict& metric) {
  const std::string limit = metric_limit(metric);
  const std::string text = metric.name + " " + metric_value(metric.value);
  return limit.empty() ? text : text + " (" + limit + ")";
}

std::string describe_worst(const io::Comparison& comparison) {
  const io::GroupComparison* worst = worst_group(comparison);
  if (worst == nullptr || !(worst->metrics.max > 0.0)) return "";
  return fmt::format("the largest difference, {}, is in {} of pixel ({}, {})",
                     metric_value(worst->metrics.max), worst->worst_channel, worst->worst_x,
                     worst->worst_y);
}

std::string why_failed(const io::Comparison& comparison) {
  std::string text;
  for (const io::MetricVerdict& metric : comparison.verdicts) {
    if (metric.failed) text += (text.empty() ? "" : ", ") + describe_metric(metric);
  }
  if (text.empty()) text = "the pixels are not equal";
  const std::string worst = describe_worst(comparison);
  return worst.empty() ? text : text + "; " + worst;
}

}  // namespace lume::cli
