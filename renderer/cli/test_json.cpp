// SPDX-License-Identifier: Apache-2.0
#include "io/report/junit.h"
#include "lume_version.h"
#include "renderer/cli/comparison_words.h"
#include "renderer/cli/test_judge.h"
#include "renderer/cli/test_report.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

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

Json to_json(const CaseResult& result) {
  const io::TestCase& test = result.planned->test;
  Json json = {{"name", test.name},
               {"verdict", verdict_name(result.verdict)},
               {"message", result.message},
               {"tier", io::tier_name(test.tier)},
               {"line", test.line},
               {"seconds", result.seconds},
               {"reference", test.reference.string()},
               {"pixels", result.pixels},
               {"identical", result.identical},
               {"metrics", Json::array()},
               {"actual", result.actual.string()},
               {"expected", result.expected.string()},
               {"difference", result.difference.string()},
               {"failing_since", result.history.failing_since},
               {"failures", result.history.failures},
               {"runs", result.history.runs}};
  for (const io::MetricVerdict& metric : result.metrics) {
    json["metrics"].push_back(to_json(metric));
  }
  if (is_failure(result.verdict)) json["accept_command"] = result.planned->accept_command;
  if (!result.update.empty()) json["update"] = result.update;
  if (!result.log.empty()) json["log"] = result.log;
  return json;
}

io::JunitCase::Outcome outcome_of(CaseVerdict verdict) {
  using Outcome = io::JunitCase::Outcome;
  if (verdict == CaseVerdict::skipped || verdict == CaseVerdict::not_run) return Outcome::skipped;
  return is_failure(verdict) ? Outcome::failed : Outcome::passed;
}

std::string details_of(const CaseResult& result) {
  std::string text;
  for (const io::MetricVerdict& metric : result.metrics) {
    text += describe_metric(metric) + (metric.failed ? "  <- failed" : "") + "\n";
  }
  for (const std::string& line : result.log) text += "| " + line + "\n";
  if (!result.actual.empty()) text += "actual: " + result.actual.string() + "\n";
  if (!result.expected.empty()) text += "expected: " + result.expected.string() + "\n";
  if (is_failure(result.verdict) && !result.pixels.empty()) {
    text += "to accept it: " + result.planned->accept_command + "\n";
  }
  const std::string history = describe_history(result.history);
  return history.empty() ? text : text + history + "\n";
}

io::JunitCase junit_case(const CaseResult& result) {
  io::JunitCase one;
  one.name = result.planned->test.name;
  one.outcome = outcome_of(result.verdict);
  one.message = result.verdict == CaseVerdict::failed || result.verdict == CaseVerdict::skipped
                    ? result.message
                    : fmt::format("{}: {}", verdict_name(result.verdict), result.message);
  if (is_failure(result.verdict)) one.details = details_of(result);
  one.seconds = result.seconds;
  one.properties.emplace_back("tier", io::tier_name(result.planned->test.tier));
  for (const io::MetricVerdict& metric : result.metrics) {
    one.properties.emplace_back(metric.name, fmt::format("{}", metric.value));
  }
  return one;
}

}  // namespace

std::string test_to_json(const TestRun& run) {
  Json json = {{"lume", k_version},
               {"command", test_command(run.options)},
               {"manifest", run.options.manifest},
               {"date", run.date},
               {"seconds", run.seconds},
               {"interrupted", run.interrupted},
               {"counts", Json::object()},
               {"cases", Json::array()}};
  for (const CaseVerdict verdict :
       {CaseVerdict::passed, CaseVerdict::accepted, CaseVerdict::failed, CaseVerdict::missing,
        CaseVerdict::flaky, CaseVerdict::skipped, CaseVerdict::not_run}) {
    json["counts"][verdict_name(verdict)] = run.count(verdict);
  }
  for (const CaseResult& result : run.results) json["cases"].push_back(to_json(result));
  // A file's name need not be UTF-8, JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string test_to_junit(const TestRun& run) {
  io::JunitSuite suite;
  suite.name = "lume test " + run.options.manifest;
  suite.class_name = run.options.manifest;
  suite.file = run.options.manifest;
  suite.timestamp = run.date;
  suite.seconds = run.seconds;
  suite.cases.reserve(run.results.size());
  for (const CaseResult& result : run.results) suite.cases.push_back(junit_case(result));
  return io::to_junit(suite);
}

}  // namespace lume::cli
