// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_options.h"

#include "io/nearest_name.h"
#include "renderer/cli/distinct_files.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/render_stats.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdlib>
#include <string_view>

namespace lume::cli {
namespace {

constexpr std::string_view k_examples = R"(
A manifest names images, how each is made, and what it has to look like: docs/image_tests.md.

Examples:
  lume test tests/images/manifest.toml
      Every case; what failed is listed, and shown in lume-test-results/report.html.
  lume test manifest.toml --filter cornell --update missing
      A first reference for one case. Look at it before it is committed.
  lume test manifest.toml --update changed
      The new pictures are right: they become the references, and their differences are printed.
  lume test manifest.toml --shard 2/4 --junit junit.xml
      The second of four machines, with results for the server.
  lume test manifest.toml --filter 'ui-*' --repeat 5
      Are these the same every time?

Exit codes: 0 all passed, 1 some failed, 2 wrong command line or manifest, 4 a file cannot be
read or written, 77 nothing ran or all was skipped, 130 interrupted.
)";

Shard parse_shard(const std::string& text) {
  constexpr std::uint64_t k_most = 10000;
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw UsageError("expected i/n, such as 2/4");
  Shard shard;
  shard.count = parse_whole(text.substr(slash + 1), 1, k_most);
  shard.index = parse_whole(text.substr(0, slash), 1, shard.count);
  return shard;
}

ReferenceUpdate parse_update(const std::string& text) {
  if (text == "missing") return ReferenceUpdate::missing;
  if (text == "changed") return ReferenceUpdate::changed;
  if (text == "all") return ReferenceUpdate::all;
  throw UsageError(unknown_name("mode", text, {"missing", "changed", "all"}));
}

void add_choice_options(CLI::App& app, TestOptions& options) {
  const std::string group = "Which cases";
  app.add_option("--filter", options.filters,
                 "Those of this name, or else with this in their names; * and ? allowed. Repeats.")
      ->type_name("PATTERN")
      ->type_size(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group(group);
  add_parsed(app, "--shard", options.shard, parse_shard,
             "The i-th of n parts; a case is in the same part each time")
      ->type_name("I/N")
      ->group(group);
}

void add_running_options(CLI::App& app, TestOptions& options) {
  const std::string group = "Running";
  app.add_option("--jobs", options.jobs, "Cases at the same time; a render uses all cores (1)")
      ->check(whole_between(1, 256))
      ->type_name("N")
      ->group(group);
  app.add_option("--repeat", options.repeat,
                 "Run each case so often; one that is not the same each time fails (1)")
      ->check(whole_between(1, 10000))
      ->type_name("N")
      ->group(group);
  add_parsed(app, "--update", options.update, parse_update,
             "Write references: missing ones; changed ones, too; or all that are not equal")
      ->type_name("MODE")
      ->group(group);
  app.add_flag("--force", options.force, "--update even where CI is set")->group(group);
}

void add_file_options(CLI::App& app, TestOptions& options) {
  const std::string group = "Results";
  app.add_option("--output", options.output,
                 "Folder of pictures, reports and history (lume-test-results)")
      ->check(file_name())
      ->type_name("DIR")
      ->group(group);
  const auto name_or_dash = [](std::string& text) {
    return text == "-" ? std::string() : file_name()(text);
  };
  app.add_option("--json", options.json,
                 "The report for programs (DIR/report.json); - is stdout, in place of the table")
      ->check(CLI::Validator(name_or_dash, ""))
      ->type_name("FILE")
      ->group(group);
  const auto file = [&](const char* name, std::optional<std::string>& value, const char* help) {
    app.add_option(name, value, help)->check(file_name())->type_name("FILE")->group(group);
  };
  file("--junit", options.junit, "The report for CI servers, as JUnit XML (DIR/junit.xml)");
  file("--html", options.html, "The report to look at; it needs no network (DIR/report.html)");
  CLI::Option* quiet = app.add_flag_callback(
      "-q,--quiet", [&options] { options.verbosity = Verbosity::quiet; }, "Only what failed");
  quiet->group(group);
  app.add_flag_callback(
         "-v,--verbose", [&options] { options.verbosity = Verbosity::verbose; },
         "A line for each case")
      ->group(group)
      ->excludes(quiet);
}

/// CI servers set CI=true (GitHub, GitLab and others).
bool is_ci() {
  const char* value = std::getenv("CI");
  if (value == nullptr) return false;
  const std::string text = io::relaxed_name(value);
  return !text.empty() && text != "0" && text != "false";
}

void check_files(const TestOptions& options) {
  DistinctFiles files;
  files.read("the manifest", options.manifest);
  if (!options.json_to_stdout()) files.write("--json", options.json_file());
  files.write("--junit", options.junit_file());
  files.write("--html", options.html_file());
  if (options.json && !options.json_to_stdout()) check_text_writable(*options.json);
  if (options.junit) check_text_writable(*options.junit);
  if (options.html) check_text_writable(*options.html);
}

}  // namespace

void add_test_options(CLI::App& app, TestOptions& options) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_option("MANIFEST", options.manifest, "The list of cases: a .toml file")
      ->type_name("FILE");
  add_choice_options(app, options);
  add_running_options(app, options);
  add_file_options(app, options);
  app.footer(std::string(k_examples));
}

void check_test_options(const TestOptions& options) {
  if (options.manifest.empty()) {
    throw UsageError("no manifest given; try: lume test manifest.toml");
  }
  if (options.update != ReferenceUpdate::none && is_ci() && !options.force) {
    throw UsageError(
        fmt::format("--update: the environment says CI={}, where references are not to change "
                    "(--force does it nevertheless)",
                    printable(std::getenv("CI"))));
  }
  check_files(options);
}

}  // namespace lume::cli
