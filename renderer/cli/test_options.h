// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/log.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;  // its header costs seconds a file
}

namespace lume::cli {

/// The i-th of n parts, from 1.
struct Shard {
  std::uint64_t index = 1;
  std::uint64_t count = 1;
};

/// Which references `lume test` writes anew: those that are not there, those that a case differs
/// from as well, or all that are not the very pixels.
enum class ReferenceUpdate { none, missing, changed, all };

/// Everything `lume test` can be told.
struct TestOptions {
  std::string manifest;
  std::vector<std::string> filters;
  Shard shard;
  unsigned jobs = 1;
  unsigned repeat = 1;
  ReferenceUpdate update = ReferenceUpdate::none;
  bool force = false;

  std::string output = "lume-test-results";
  std::optional<std::string> json;  ///< "-": stdout, in place of the table
  std::optional<std::string> junit;
  std::optional<std::string> html;
  Verbosity verbosity = Verbosity::normal;
  std::vector<std::string> arguments;  ///< the command line after `lume test`, to be quoted

  [[nodiscard]] bool json_to_stdout() const { return json == "-"; }
  [[nodiscard]] std::filesystem::path json_file() const { return file(json, "report.json"); }
  [[nodiscard]] std::filesystem::path junit_file() const { return file(junit, "junit.xml"); }
  [[nodiscard]] std::filesystem::path html_file() const { return file(html, "report.html"); }
  [[nodiscard]] std::filesystem::path history_file() const { return file({}, "history.json"); }

 private:
  [[nodiscard]] std::filesystem::path file(const std::optional<std::string>& asked,
                                           const char* name) const {
    return asked && *asked != "-" ? std::filesystem::path(*asked)
                                  : std::filesystem::path(output) / name;
  }
};

/// Adds every option of `lume test` to `app`; parsing fills `options`, which must outlive it.
void add_test_options(CLI::App& app, TestOptions& options);

/// What one option alone cannot know. Throws UsageError; io::Error for files that cannot be
/// written.
void check_test_options(const TestOptions& options);

}  // namespace lume::cli
