// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/svg_writer.h"
#include "renderer/cli/test_report.h"
#include "renderer/cli/text.h"
#include "renderer/cli/text_table.h"

#include <fmt/format.h>

#include <string_view>

namespace lume::cli {
namespace {

constexpr std::size_t k_most_words = 100;  // characters of a message in the table

/// "2026-11-02T10:15:30Z" as people read it.
std::string readable_date(std::string_view date) {
  if (date.size() != 20) return std::string(date);
  return fmt::format("{} {} UTC", date.substr(0, 10), date.substr(11, 5));
}

bool is_listed(const CaseResult& result, Verbosity verbosity) {
  if (verbosity == Verbosity::verbose) return true;
  if (verbosity == Verbosity::quiet) return is_failure(result.verdict);
  return result.verdict != CaseVerdict::passed && result.verdict != CaseVerdict::accepted;
}

std::string failed_runs(const CaseHistory& history) {
  return history.failures > 0 ? fmt::format("{} of {}", history.failures, history.runs) : "";
}

}  // namespace

std::string test_command(const TestOptions& options) {
  std::string command = "lume test";
  for (const std::string& argument : options.arguments) {
    command += " " + shell_quote(printable(argument));
  }
  return command;
}

std::string describe_history(const CaseHistory& history) {
  const std::string failures =
      history.failures > 0
          ? fmt::format("failed in {} of the last {} runs", history.failures, history.runs)
          : "";
  if (history.failing_since.empty()) return failures;
  return fmt::format("failing since {}, {}", readable_date(history.failing_since), failures);
}

std::string summarize(const TestRun& run) {
  const std::size_t cases = run.results.size();
  std::string text;
  for (const CaseVerdict verdict :
       {CaseVerdict::passed, CaseVerdict::accepted, CaseVerdict::failed, CaseVerdict::missing,
        CaseVerdict::flaky, CaseVerdict::skipped, CaseVerdict::not_run}) {
    const std::size_t count = run.count(verdict);
    if (count == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict_name(verdict));
  }
  return fmt::format("{} case{}{}{}", cases, cases == 1 ? "" : "s", text.empty() ? "" : ": ", text);
}

std::string case_lines(const CaseResult& result) {
  const std::string& name = result.planned->test.name;
  std::string text = fmt::format("lume: {}: {}", verdict_name(result.verdict), printable(name));
  if (!result.message.empty()) text += ": " + result.message;
  text += "\n";
  for (const std::string& line : result.log) text += "    | " + line + "\n";
  return text;
}

std::string test_to_text(const TestRun& run) {
  const Verbosity verbosity = run.options.verbosity;
  std::string text;
  for (const CaseResult& result : run.results) {
    if (!result.update.empty()) text += result.update + "\n";
  }
  TextTable table{"", {"case", "verdict", "failed\nin runs", "failing since", "seconds"}, {}};
  for (const CaseResult& result : run.results) {
    if (!is_listed(result, verbosity)) continue;
    const CaseHistory& history = result.history;
    table.rows.push_back({shorten(printable(result.planned->test.name), k_most_words),
                          verdict_name(result.verdict), failed_runs(history),
                          readable_date(history.failing_since),
                          fmt::format("{:.2f}", result.seconds)});
  }
  if (!table.rows.empty()) text += draw_table(table);
  if (verbosity == Verbosity::quiet && run.failures() == 0) return text;
  text += fmt::format("{} in {}; report: {}\n", summarize(run), format_duration(run.seconds),
                      printable(run.options.html_file().string()));
  return text;
}

}  // namespace lume::cli
