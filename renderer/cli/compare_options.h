// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/compare/comparison.h"
#include "renderer/cli/log.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;  // its header costs seconds a file
}

namespace lume::cli {

/// Everything `lume compare` can be told.
struct CompareOptions {
  std::string actual;
  std::string expected;
  io::CompareSettings settings;
  std::vector<std::string> ignored;  ///< patterns of channels that are not looked at

  bool statistical = false;
  std::vector<std::string> actual_seeds;  ///< more images of the actual side
  std::vector<std::string> expected_seeds;
  double significance = 0.01;

  std::optional<std::string> json;  ///< "-": stdout, in place of the text
  std::optional<std::string> diff;
  std::optional<std::string> html;
  Verbosity verbosity = Verbosity::normal;
  std::vector<std::string> arguments;  ///< the command line after `lume compare`, to be quoted

  [[nodiscard]] bool json_to_stdout() const { return json == "-"; }
  /// Noisy images are compared by what their spread allows to say.
  [[nodiscard]] bool is_statistical() const {
    return statistical || !actual_seeds.empty() || !expected_seeds.empty();
  }
};

/// Adds every option of `lume compare` to `app`; parsing fills `options`, which must outlive it.
void add_compare_options(CLI::App& app, CompareOptions& options);

/// What one option alone cannot know, and whether the files can be written. Throws UsageError and
/// io::Error.
void check_compare_options(const CompareOptions& options);

}  // namespace lume::cli
