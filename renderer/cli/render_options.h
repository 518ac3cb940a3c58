// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"
#include "renderer/cli/log.h"
#include "shading/image.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;  // its header costs seconds a file
}

namespace lume::cli {

/// Everything `lume render` can be told. Lengths and positions are in metres of the world, angles
/// in degrees, as they were typed.
struct RenderOptions {
  std::string scene_file;
  std::vector<std::string> outputs;  ///< as typed: #### stands for the frame's number

  std::optional<std::string> scene;
  bool tessellated = false;  ///< triangles instead of analytic shapes
  std::optional<std::string> camera;
  std::optional<geometry::DVec3> orbit;  ///< theta, phi, radius
  std::optional<geometry::DVec3> target;
  std::optional<float> fov;

  std::optional<int> width;
  std::optional<int> height;
  std::optional<shading::PixelRegion> crop;
  std::uint32_t spp = 16;
  std::string filter;
  float filter_radius = 0.0f;  ///< 0: the filter's usual one
  std::uint64_t seed = 0;

  std::string integrator;
  int max_depth = 5;
  std::string accelerator;
  unsigned threads = 0;

  std::optional<std::string> environment;
  float environment_rotation = 0.0f;
  float environment_intensity = 1.0f;
  bool environment_hidden = false;
  std::optional<geometry::DVec3> background;

  float exposure = 0.0f;
  std::string display;
  std::string view;
  std::string ocio;
  std::vector<std::string> aovs;
  bool full_float = false;
  std::string compression = "zip";
  int jpeg_quality = 95;

  std::optional<std::string> stats;
  Verbosity verbosity = Verbosity::normal;
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
