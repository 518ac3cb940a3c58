// SPDX-License-Identifier: Apache-2.0
// The options that `lume render` and `lume trace` share: what is seen, from where, in which light,
// and by which method.
#pragma once

#include "geometry/math.h"
#include "renderer/cli/log.h"
#include "shading/image.h"

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;  // its header costs seconds a file
}

namespace lume::cli {

/// Lengths and positions are in metres of the world, angles in degrees, as they were typed.
struct ViewOptions {
  std::string scene_file;
  std::optional<std::string> scene;
  std::optional<double> time;            ///< seconds into the animation
  std::optional<std::string> animation;  ///< which one
  bool tessellated = false;              ///< triangles instead of analytic shapes

  std::optional<std::string> camera;
  std::optional<geometry::DVec3> orbit;  ///< theta, phi, radius
  std::optional<geometry::DVec3> target;
  std::optional<float> fov;
  std::optional<float> aperture;  ///< diameter of the lens
  std::optional<float> focus;     ///< from the camera, along its axis

  std::optional<int> width;
  std::optional<int> height;
  std::uint32_t spp = 16;
  std::string filter;
  float filter_radius = 0.0f;  ///< 0: the filter's usual one
  std::uint64_t seed = 0;

  std::string integrator;
  int max_depth = 5;
  float cutoff = 1e-4f;
  bool no_shadows = false;
  std::string accelerator;

  std::optional<std::string> environment;
  float environment_rotation = 0.0f;
  float environment_intensity = 1.0f;
  bool environment_hidden = false;
  std::optional<geometry::DVec3> background;
  std::optional<geometry::DVec3> ambient;
  float occlusion_distance = 0.0f;

  Verbosity verbosity = Verbosity::normal;
};

/// Adds these options to `app`, group by group, as its help shows them; parsing fills `options`,
/// which must outlive it.
void add_view_options(CLI::App& app, ViewOptions& options);
void add_verbosity_options(CLI::App& app, ViewOptions& options, const std::string& group);

/// What one option alone cannot know: combinations that contradict each other. Throws UsageError.
void check_view_options(const ViewOptions& options);

}  // namespace lume::cli
