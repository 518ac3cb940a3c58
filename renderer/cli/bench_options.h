// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/view_options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lume::cli {

/// Everything `lume bench` can be told. `scene_file` is that of the scene at work.
struct BenchOptions : ViewOptions {
  std::vector<std::string> scene_files;
  std::vector<std::string> accelerators;  ///< the first is the baseline; with a slash: plugins
  std::vector<std::string> rays;          ///< names of ray_set_infos()
  std::size_t count = std::size_t{1} << 18;
  std::optional<double> hit_rate;  ///< percent
  unsigned repeat = 9;
  unsigned threads = 1;
  double budget = 0.25;  ///< seconds a measurement

  bool prove = false;
  std::optional<std::string> replay;
  std::optional<std::string> cost_maps;  ///< how the files' names begin

  std::optional<std::string> json;  ///< "-": stdout, in place of the text
  std::optional<std::string> csv;
  std::optional<std::string> html;
  std::optional<std::string> save_rays;
  std::optional<std::string> load_rays;
  std::optional<std::string> save_mismatch;
  std::vector<std::string> arguments;  ///< the command line after `lume bench`, to be quoted

  [[nodiscard]] bool json_to_stdout() const { return json == "-"; }
};

/// Adds every option of `lume bench` to `app`; parsing fills `options`, which must outlive it.
void add_bench_options(CLI::App& app, BenchOptions& options);

/// What one option alone cannot know, and whether the files can be written. Throws UsageError and
/// io::Error.
void check_bench_options(const BenchOptions& options);

/// The structures between commas: names, "all", and files of plugins, which have a slash. Throws
/// UsageError.
[[nodiscard]] std::vector<std::string> parse_accelerators(const std::string& text);

}  // namespace lume::cli
