// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_history.h"

#include "renderer/cli/render_stats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <system_error>
#include <utility>

namespace lume::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int k_version = 1;
constexpr std::size_t k_most_runs = 50;
constexpr const char* k_passing[] = {"passed", "accepted"};

bool is_passing(const std::string& verdict) {
  for (const char* passing : k_passing) {
    if (verdict == passing) return true;
  }
  return false;
}

}  // namespace

TestHistory TestHistory::read(const std::filesystem::path& file, std::string& warning) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  try {
    const Json json = Json::parse(std::ifstream(file, std::ios::binary));
    if (json.at("version") != k_version) throw std::runtime_error("another version");
    TestHistory history;
    for (const Json& run : json.at("runs")) {
      history.runs_.push_back({run.at("date").get<std::string>(), {}});
      for (const auto& [name, verdict] : run.at("verdicts").items()) {
        history.runs_.back().verdicts[name] = verdict.get<std::string>();
      }
    }
    for (const auto& [name, date] : json.at("failing_since").items()) {
      history.failing_since_[name] = date.get<std::string>();
    }
    return history;
  } catch (const std::exception&) {
    warning = fmt::format("{} is no history of lume test; it begins anew", file.string());
    return {};
  }
}

void TestHistory::add_run(const std::string& date, const std::vector<HistoryEntry>& entries) {
  Run run{date, {}};
  for (const HistoryEntry& entry : entries) {
    run.verdicts[entry.name] = entry.verdict;
    if (entry.failed) failing_since_.emplace(entry.name, date);  // unless it has failed before
    if (!entry.failed) failing_since_.erase(entry.name);
  }
  runs_.push_back(std::move(run));
  if (runs_.size() > k_most_runs) runs_.erase(runs_.begin());
}

CaseHistory TestHistory::of(const std::string& name) const {
  CaseHistory history;
  for (const Run& run : runs_) {
    const auto verdict = run.verdicts.find(name);
    if (verdict == run.verdicts.end()) continue;
    ++history.runs;
    if (!is_passing(verdict->second)) ++history.failures;
  }
  const auto since = failing_since_.find(name);
  if (since != failing_since_.end()) history.failing_since = since->second;
  return history;
}

void TestHistory::write(const std::filesystem::path& file) const {
  Json json = {{"version", k_version}, {"runs", Json::array()}, {"failing_since", failing_since_}};
  for (const Run& run : runs_) {
    json["runs"].push_back({{"date", run.date}, {"verdicts", run.verdicts}});
  }
  // A name need not be UTF-8, JSON must be.
  write_text(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace lume::cli
