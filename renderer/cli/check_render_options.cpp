// SPDX-License-Identifier: Apache-2.0
#include "io/image_io.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/output_name.h"
#include "renderer/cli/render_options.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

namespace lume::cli {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

using RoleAndPath = std::pair<std::string, std::filesystem::path>;

/// One form for all spellings of a path, whether or not the file is there.
std::filesystem::path canonical_path(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path result =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path), ignored);
  return result.empty() ? path : result;
}

/// No written file may be another one that is written, nor one that is read.
void check_paths_differ(const RenderOptions& options) {
  std::vector<RoleAndPath> taken = {{"the scene", canonical_path(options.scene_file)}};
  if (options.environment) taken.emplace_back("--env", canonical_path(*options.environment));
  if (!options.ocio.empty()) taken.emplace_back("--ocio", canonical_path(options.ocio));
  std::vector<RoleAndPath> written;
  for (const std::string& output : options.outputs) {
    written.emplace_back("-o", canonical_path(frame_path(output, 1)));
  }
  if (options.stats) written.emplace_back("--stats", canonical_path(*options.stats));
  for (const auto& [role, path] : written) {
    for (const auto& [other_role, other] : taken) {
      if (path == other) {
        throw UsageError(fmt::format("{} and {} are the same file: {}", other_role, role,
                                     printable(path.string())));
      }
    }
    taken.emplace_back(role, path);
  }
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
  check_paths_differ(options);
}

}  // namespace lume::cli
