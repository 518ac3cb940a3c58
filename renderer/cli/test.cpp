// SPDX-License-Identifier: Apache-2.0
// `lume test`: the images of a manifest against their references.
#include "geometry/parallel.h"
#include "io/image_tests/manifest.h"
#include "renderer/cli/commands.h"
#include "renderer/cli/interrupt.h"
#include "renderer/cli/progress.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/test_case.h"
#include "renderer/cli/test_report.h"
#include "renderer/cli/test_update.h"
#include "renderer/cli/whole_file.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <ctime>
#include <memory>
#include <utility>

namespace lume::cli {
namespace {

/// ISO 8601, in UTC and whole seconds.
std::string date_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32] = {};
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

Progress::Style progress_style(const TestOptions& options) {
  const bool shown = options.verbosity != Verbosity::quiet && isatty(fileno(stderr)) == 1;
  return shown ? Progress::Style::bar : Progress::Style::none;
}

bool is_told(const CaseResult& result, Verbosity verbosity) {
  return is_failure(result.verdict) || verbosity == Verbosity::verbose;
}

/// Says at once what failed, unless references are still to change.
std::vector<CaseResult> run_watched(const std::vector<PlannedCase>& plan,
                                    const TestOptions& options) {
  Progress progress(stderr, progress_style(options));
  const Stopwatch watch;
  std::size_t done = 0;
  const bool is_final = options.update == ReferenceUpdate::none;
  return run_cases(plan, options.jobs, options.repeat, InterruptGuard::flag(),
                   [&](const CaseResult& result) {
                     ++done;
                     if (is_final && is_told(result, options.verbosity)) {
                       progress.clear();
                       fmt::print(stderr, "{}", case_lines(result));
                     }
                     progress.update(static_cast<double>(done) / static_cast<double>(plan.size()),
                                     watch.elapsed());
                   });
}

void update_watched(TestRun& run) {
  if (run.options.update == ReferenceUpdate::none) return;
  update_references(run, InterruptGuard::flag());
  for (const CaseResult& result : run.results) {
    if (is_told(result, run.options.verbosity)) fmt::print(stderr, "{}", case_lines(result));
  }
}

void remember(TestRun& run) {
  std::string warning;
  TestHistory history = TestHistory::read(run.options.history_file(), warning);
  if (!warning.empty()) spdlog::warn("{}", warning);
  std::vector<HistoryEntry> entries;
  for (const CaseResult& result : run.results) {
    if (result.verdict == CaseVerdict::skipped || result.verdict == CaseVerdict::not_run) continue;
    entries.push_back(
        {result.planned->test.name, verdict_name(result.verdict), is_failure(result.verdict)});
  }
  if (!entries.empty()) history.add_run(run.date, entries);
  for (CaseResult& result : run.results) {
    result.history = history.of(result.planned->test.name);
  }
  history.write(run.options.history_file());
}

void write_reports(const TestRun& run) {
  const TestOptions& options = run.options;
  if (!options.json_to_stdout()) write_text(options.json_file(), test_to_json(run));
  write_text(options.junit_file(), test_to_junit(run));
  write_text(options.html_file(), test_to_html(run));
}

ExitCode exit_code(const TestRun& run) {
  if (run.interrupted) return ExitCode::interrupted;
  if (run.failures() > 0) return ExitCode::differs;
  const std::size_t good = run.count(CaseVerdict::passed) + run.count(CaseVerdict::accepted);
  return good > 0 ? ExitCode::success : ExitCode::skipped;
}

ExitCode run_test(const TestOptions& options) {
  start_log(Verbosity::quiet);  // what a render has to say would be told between the cases
  check_test_options(options);
  std::vector<PlannedCase> plan;
  try {
    plan = plan_tests(io::read_manifest(options.manifest), options);
  } catch (const io::ManifestError& error) {
    throw UsageError(error.what());
  }
  make_folder(options.output);

  const InterruptGuard interrupt(options.verbosity != Verbosity::quiet);
  const geometry::ThreadLimit limit(0);
  TestRun run{options, date_now(), 0.0, false, {}};
  const Stopwatch watch;
  run.results = run_watched(plan, options);
  update_watched(run);
  run.interrupted = InterruptGuard::flag();
  run.seconds = watch.elapsed();
  remember(run);
  write_reports(run);
  print_result(options.json_to_stdout() ? test_to_json(run) : test_to_text(run));
  return exit_code(run);
}

}  // namespace

Command add_test_command(CLI::App& parent, std::vector<std::string> arguments) {
  // Shared with the closure, which outlives this function.
  const auto options = std::make_shared<TestOptions>();
  options->arguments = std::move(arguments);
  CLI::App* app = parent.add_subcommand("test", "Hold images against their references");
  add_test_options(*app, *options);
  return {app, [options] { return run_test(*options); }};
}

}  // namespace lume::cli
