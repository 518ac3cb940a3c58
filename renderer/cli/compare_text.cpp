// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/compare_report.h"
#include "renderer/cli/comparison_words.h"
#include "renderer/cli/text.h"
#include "renderer/cli/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace lume::cli {
namespace {

ExitCode refusal_code(io::Refusal refusal) {
  switch (refusal) {
    case io::Refusal::non_finite:
      return ExitCode::non_finite;
    case io::Refusal::size:
      return ExitCode::size;
    case io::Refusal::data_window:
      return ExitCode::data_window;
    case io::Refusal::channels:
      return ExitCode::channels;
    case io::Refusal::none:
      break;
  }
  return ExitCode::success;
}

TextTable metrics_table(const io::Comparison& comparison) {
  TextTable table{"", {"metric", "value", "limit", ""}, {}};
  for (const io::MetricVerdict& metric : comparison.verdicts) {
    table.rows.push_back({printable(metric.name), metric_value(metric.value), metric_limit(metric),
                          metric.failed ? "failed" : ""});
  }
  return table;
}

}  // namespace

ExitCode exit_code(const CompareDocument& document) {
  if (document.comparison.refusal != io::Refusal::none) {
    return refusal_code(document.comparison.refusal);
  }
  return document.passed() ? ExitCode::success : ExitCode::differs;
}

std::string verdict(const CompareDocument& document) {
  if (document.comparison.refusal != io::Refusal::none) return "refused";
  return document.passed() ? "passed" : "failed";
}

std::string reason(const CompareDocument& document) {
  const io::Comparison& comparison = document.comparison;
  if (comparison.refusal != io::Refusal::none) return comparison.message;
  if (document.statistics) return io::describe(*document.statistics);
  if (comparison.identical()) return "the pixels are equal";
  if (!comparison.passed) return why_failed(comparison);
  return "within the limits; " + describe_worst(comparison);
}

std::string compare_to_text(const CompareDocument& document) {
  const io::Comparison& comparison = document.comparison;
  std::string text = fmt::format("{}: {}\n", verdict(document), printable(reason(document)));
  if (comparison.refusal != io::Refusal::none) return text;
  text += fmt::format("pixels of {}: {}\npixels of {}: {}\n", printable(document.actual.path),
                      comparison.actual_hash, printable(document.expected.path),
                      comparison.expected_hash);
  return text + draw_table(metrics_table(comparison));
}

}  // namespace lume::cli
