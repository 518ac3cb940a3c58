// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/view_options.h"
#include "shading/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lume::cli {

/// Everything `lume render` can be told.
struct RenderOptions : ViewOptions {
  std::vector<std::string> outputs;  ///< as typed: #### stands for the frame's number
  std::optional<shading::PixelRegion> crop;
  unsigned threads = 0;

  float exposure = 0.0f;
  std::string display;
  std::string view;
  std::string ocio;
  std::vector<std::string> aovs;
  bool full_float = false;
  std::string compression = "zip";
  int jpeg_quality = 95;

  std::optional<std::string> stats;
  std::vector<std::string> arguments;  ///< the command line after `lume render`, to be quoted
};

/// Adds every option of `lume render` to `app`; parsing fills `options`, which must outlive it.
void add_render_options(CLI::App& app, RenderOptions& options);

/// What one option alone cannot know: combinations that contradict each other, and files that would
/// overwrite each other. Throws UsageError.
void check_render_options(const RenderOptions& options);

/// True for a file in which scene-linear values and further layers can stand.
[[nodiscard]] bool is_exr(const std::filesystem::path& path);
/// True for a file whose values have gone through a display transform.
[[nodiscard]] bool is_display_format(const std::filesystem::path& path);

}  // namespace lume::cli
