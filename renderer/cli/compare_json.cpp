// SPDX-License-Identifier: Apache-2.0
#include "lume_version.h"
#include "renderer/cli/compare_report.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace lume::cli {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: null stands for it.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const io::MetricVerdict& metric) {
  Json json = {{"name", metric.name}, {"value", number(metric.value)}, {"failed", metric.failed}};
  if (metric.limit) {
    json["limit"] = number(*metric.limit);
    json["limit_is"] = metric.at_least ? "least" : "most";
  }
  return json;
}

Json to_json(const io::GroupComparison& group) {
  return {{"name", group.name},
          {"channels", group.channels},
          {"largest_difference",
           {{"value", number(group.metrics.max)},
            {"channel", group.worst_channel},
            {"x", group.worst_x},
            {"y", group.worst_y}}}};
}

Json to_json(const io::FlipSummary& flip) {
  return {{"mean", flip.mean},
          {"weighted_median", flip.weighted_median},
          {"first_weighted_quartile", flip.first_weighted_quartile},
          {"third_weighted_quartile", flip.third_weighted_quartile},
          {"min", flip.min},
          {"max", flip.max}};
}

Json to_json(const io::StatisticalFamily& family) {
  Json json = {{"passed", family.passed},
               {"tests", family.tests},
               {"smallest_p", family.smallest_p()},
               {"threshold", family.threshold},
               {"worst",
                {{"channel", family.channel},
                 {"x", family.x},
                 {"y", family.y},
                 {"width", family.width},
                 {"height", family.height},
                 {"difference", number(family.difference)},
                 {"relative_difference", number(family.relative_difference)}}}};
  if (family.detectable_bias) json["detectable_bias"] = number(*family.detectable_bias);
  return json;
}

}  // namespace

std::string compare_to_json(const CompareDocument& document) {
  const io::Comparison& comparison = document.comparison;
  Json json = {{"lume", k_version},
               {"actual", document.actual.path},
               {"expected", document.expected.path},
               {"verdict", verdict(document)},
               {"reason", reason(document)},
               {"exit_code", static_cast<int>(exit_code(document))}};
  if (comparison.refusal == io::Refusal::none) {
    json["identical"] = comparison.identical();
    json["actual_pixels"] = comparison.actual_hash;
    json["expected_pixels"] = comparison.expected_hash;
    for (const io::MetricVerdict& metric : comparison.verdicts) {
      json["metrics"].push_back(to_json(metric));
    }
    for (const io::GroupComparison& group : comparison.groups) {
      json["groups"].push_back(to_json(group));
    }
    if (comparison.has_color) {
      json["flip"] = to_json(comparison.flip);
      json["flip"]["kind"] = comparison.is_hdr ? "HDR" : "LDR";
    }
  }
  if (document.statistics) {
    json["statistics"] = {{"significance", document.statistics->significance},
                          {"fireflies", document.statistics->fireflies},
                          {"pixels", to_json(document.statistics->pixels)},
                          {"tiles", to_json(document.statistics->tiles)},
                          {"image", to_json(document.statistics->image)}};
  }
  // File names may be any bytes.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lume::cli
