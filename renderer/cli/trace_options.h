// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/view_options.h"

#include <cstdint>
#include <optional>
#include <string>

namespace lume::cli {

struct PixelPlace {
  int x = 0;  ///< from the left, from 0
  int y = 0;  ///< from the top
};

/// Everything `lume trace` can be told.
struct TraceOptions : ViewOptions {
  std::optional<PixelPlace> pixel;
  std::uint32_t sample = 0;         ///< whose tree is printed and drawn
  std::optional<std::string> json;  ///< "-": stdout, in place of the text
  std::optional<std::string> svg;
  std::optional<std::string> gltf;

  [[nodiscard]] bool json_to_stdout() const { return json == "-"; }
};

/// Adds every option of `lume trace` to `app`; parsing fills `options`, which must outlive it.
void add_trace_options(CLI::App& app, TraceOptions& options);

/// What one option alone cannot know, but for what depends on the picture's size, and whether the
/// files can be written. Throws UsageError and io::Error.
void check_trace_options(const TraceOptions& options);

}  // namespace lume::cli
