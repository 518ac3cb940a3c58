// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/check_report.h"

#include "lume_version.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace lume::cli {
namespace {

using io::check::Finding;
using io::check::Severity;

constexpr std::array<std::string_view, 3> k_names = {"error", "warning", "advice"};

std::string_view name_of(Severity severity) { return k_names[static_cast<std::size_t>(severity)]; }

std::size_t count(const std::vector<Finding>& findings, Severity severity) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [&](const Finding& finding) { return finding.severity == severity; }));
}

std::string place_of(const Finding& finding) {
  std::string place = finding.pointer.empty() ? "the file" : printable(finding.pointer);
  if (finding.count > 1) place += fmt::format(" and {} more", format_count(finding.count - 1));
  return place;
}

}  // namespace

std::string check_to_text(const std::vector<Finding>& findings, const std::string& file) {
  std::string text;
  for (const Finding& finding : findings) {
    text += fmt::format("{:<8} {}  [{}]\n         {}\n         -> {}\n", name_of(finding.severity),
                        place_of(finding), finding.code, printable(finding.message),
                        printable(finding.advice));
  }
  const std::size_t warnings = count(findings, Severity::warning);
  if (count(findings, Severity::error) > 0) {
    text += fmt::format("{}: Lume refuses it\n", printable(file));
  } else if (findings.empty()) {
    text += fmt::format("{}: nothing to complain of\n", printable(file));
  } else {
    text += fmt::format("{}: can be rendered; {} warning{}, {} of advice\n", printable(file),
                        warnings, warnings == 1 ? "" : "s", count(findings, Severity::advice));
  }
  return text;
}

std::string check_to_json(const std::vector<Finding>& findings, const std::string& file) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", name_of(finding.severity)},
                    {"code", finding.code},
                    {"pointer", finding.pointer},
                    {"count", finding.count},
                    {"message", finding.message},
                    {"advice", finding.advice}});
  }
  const Json json = {{"lume", k_version},
                     {"file", file},
                     {"errors", count(findings, Severity::error)},
                     {"warnings", count(findings, Severity::warning)},
                     {"advice", count(findings, Severity::advice)},
                     {"findings", std::move(list)}};
  // Names that are not UTF-8 must not make the JSON invalid.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lume::cli
