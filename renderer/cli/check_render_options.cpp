// SPDX-License-Identifier: Apache-2.0
#include "io/image_io.h"
#include "renderer/cli/distinct_files.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/output_name.h"
#include "renderer/cli/render_options.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace lume::cli {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_files_differ(const RenderOptions& options) {
  DistinctFiles files;
  files.read("the scene", options.scene_file);
  if (options.environment) files.read("--env", *options.environment);
  if (!options.ocio.empty()) files.read("--ocio", options.ocio);
  for (const std::string& output : options.outputs) files.write("-o", frame_path(output, 1));
  if (options.stats) files.write("--stats", *options.stats);
}

}  // namespace

bool is_exr(const std::filesystem::path& path) { return lower_extension(path) == ".exr"; }

bool is_display_format(const std::filesystem::path& path) {
  const auto extensions = io::display_extensions();
  return std::find(extensions.begin(), extensions.end(), lower_extension(path)) != extensions.end();
}

void check_render_options(const RenderOptions& options) {
  if (options.scene_file.empty()) {
    throw UsageError("no scene given; try: lume render SCENE.glb -o picture.png");
  }
  if (options.outputs.empty()) {
    throw UsageError(fmt::format("no output given; try: lume render {} -o picture.png",
                                 shell_quote(printable(options.scene_file))));
  }
  check_view_options(options);
  const bool any_exr = std::any_of(options.outputs.begin(), options.outputs.end(),
                                   [](const std::string& output) { return is_exr(output); });
  if (!options.aovs.empty() && !any_exr) {
    throw UsageError("--aov needs an EXR output to hold the layers; add: -o layers.exr");
  }
  check_files_differ(options);
}

}  // namespace lume::cli
