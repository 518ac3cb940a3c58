// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/view_options.h"

#include "geometry/accelerators/accelerator.h"
#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"
#include "renderer/integrator.h"
#include "renderer/pixel_filter.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <limits>

namespace lume::cli {
namespace {

constexpr double k_max_coordinate = 1e12;  // metres; beyond it even doubles lose the millimetres
constexpr double k_max_time = 1e9;         // seconds
constexpr double k_max_angle = 36000.0;    // degrees
constexpr std::uint64_t k_max_side = 65535;

void add_input_options(CLI::App& app, ViewOptions& options) {
  app.add_option("SCENE", options.scene_file, "The scene: a .gltf or .glb file")->type_name("FILE");
  app.add_option("--scene", options.scene, "Which scene of the file (the file's default)")
      ->type_name("NAME|N");
  CLI::Option* time = app.add_option(
      "--time", options.time, "Seconds into the animation (nodes stay where they were modelled)");
  time->check(real_between(0.0, k_max_time))->type_name("SECONDS");
  app.add_option("--animation", options.animation, "Which animation of the file (its first)")
      ->type_name("NAME|N")
      ->needs(time);
  app.add_flag("--tessellated", options.tessellated,
               "Draw the triangles that stand in for analytic shapes in other viewers, instead "
               "of the shapes");
}

void add_camera_options(CLI::App& app, ViewOptions& options) {
  const std::string group = "Camera";
  CLI::Option* camera =
      app.add_option("--camera", options.camera,
                     "Which camera of the file (its first, or one that frames the scene)");
  camera->type_name("NAME|N")->group(group);
  const auto triple = [](const std::string& text) { return parse_triple(text, k_max_coordinate); };
  add_parsed(app, "--orbit", options.orbit, triple,
             "A camera around the target: degrees about +y from +z, degrees from +y, metres")
      ->type_name("THETA,PHI,RADIUS")
      ->group(group);
  add_parsed(app, "--target", options.target, triple,
             "What --orbit looks at, in the world (centre of the scene)")
      ->type_name("X,Y,Z")
      ->group(group);
  app.add_option("--fov", options.fov, "Vertical field of view of a perspective camera (45)")
      ->check(real_between(0.01, 179.0))
      ->type_name("DEGREES")
      ->group(group);
  const auto length = [&](const char* name, std::optional<float>& value, const char* help) {
    app.add_option(name, value, help)
        ->check(real_between(0.0, k_max_coordinate))
        ->type_name("METRES")
        ->group(group);
  };
  length("--aperture", options.aperture,
         "Diameter of the lens; what is not in focus is blurred (0: all is sharp)");
  length(
      "--focus", options.focus,
      "Where it is sharp, from the camera along its axis (what the middle of the picture shows)");
}

void add_picture_options(CLI::App& app, ViewOptions& options) {
  const std::string group = "Picture";
  app.add_option("--width", options.width, "Pixels (1280, or by the camera's shape)")
      ->check(whole_between(1, k_max_side))
      ->type_name("N")
      ->group(group);
  app.add_option("--height", options.height, "Pixels (by the camera's shape, or 16:9)")
      ->check(whole_between(1, k_max_side))
      ->type_name("N")
      ->group(group);
  app.add_option("--spp", options.spp, "Samples a pixel (16)")
      ->check(whole_between(1, 1u << 20u))
      ->type_name("N")
      ->group(group);
  options.filter = "blackman-harris";
  add_choice(app, "--filter", options.filter, "filter", to_strings(renderer::PixelFilter::names()),
             group);
  app.add_option("--filter-radius", options.filter_radius, "Pixels (by the filter)")
      ->check(real_between(0.01, 32.0))
      ->type_name("R")
      ->group(group);
  app.add_option("--seed", options.seed, "Another number, another noise (0)")
      ->check(whole_between(0, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("N")
      ->group(group);
}

void add_method_options(CLI::App& app, ViewOptions& options) {
  const std::string group = "Method";
  add_choice(app, "--integrator", options.integrator, "integrator",
             to_strings(renderer::integrator_names()), group);
  app.add_option("--max-depth", options.max_depth, "Reflections and refractions in a row (5)")
      ->check(whole_between(0, 100))  // each one is a level of recursion on the stack
      ->type_name("N")
      ->group(group);
  app.add_option("--cutoff", options.cutoff,
                 "Leave out rays that count for less in the pixel; 0: none (0.0001)")
      ->check(real_between(0.0, 1.0))
      ->type_name("W")
      ->group(group);
  app.add_flag("--no-shadows", options.no_shadows, "Let the lights shine through everything")
      ->group(group);
  const std::vector<std::string> accelerators = to_strings(geometry::accelerator_names());
  options.accelerator = accelerators.front();
  app.add_option("--accelerator", options.accelerator,
                 fmt::format("{}, or the file of a plugin, ./mine.so ({})",
                             list_names(accelerators), options.accelerator))
      ->check(name_or_file("accelerator", accelerators))
      ->type_name("NAME|FILE")
      ->group(group);
}

void add_light_options(CLI::App& app, ViewOptions& options) {
  const std::string group = "Light";
  CLI::Option* file = app.add_option("--env", options.environment,
                                     "Light from an equirectangular .hdr or .exr all around");
  file->type_name("FILE")->group(group);
  app.add_option("--env-rotate", options.environment_rotation,
                 "Turn it counter-clockwise about +y (0)")
      ->check(real_between(-k_max_angle, k_max_angle))
      ->type_name("DEGREES")
      ->group(group)
      ->needs(file);
  app.add_option("--env-intensity", options.environment_intensity, "Multiply it (1)")
      ->check(real_between(0.0, 1e6))
      ->type_name("F")
      ->group(group)
      ->needs(file);
  app.add_flag("--env-hidden", options.environment_hidden,
               "Light with it, but leave the backdrop transparent")
      ->group(group)
      ->needs(file);
  const auto color = [](const std::string& text) {
    const geometry::DVec3 value = parse_triple(text, 1e9);
    if (value.x >= 0.0 && value.y >= 0.0 && value.z >= 0.0) return value;
    throw UsageError(fmt::format("light cannot be negative, got '{}'", printable(text)));
  };
  add_parsed(app, "--background", options.background, color,
             "The same light from everywhere instead: linear Rec.709, nits")
      ->type_name("R,G,B")
      ->group(group)
      ->excludes(file);
  add_parsed(app, "--ambient", options.ambient, color,
             "Light that reaches every place, whatever stands around it: L_a of the course (none, "
             "or the file's)")
      ->type_name("R,G,B")
      ->group(group);
  app.add_option("--occlusion", options.occlusion_distance,
                 "Let surfaces within this distance keep it from each other; 0: no (0)")
      ->check(real_between(0.0, k_max_coordinate))
      ->type_name("METRES")
      ->group(group);
}

}  // namespace

void add_view_options(CLI::App& app, ViewOptions& options) {
  add_input_options(app, options);
  add_camera_options(app, options);
  add_picture_options(app, options);
  add_method_options(app, options);
  add_light_options(app, options);
}

void add_verbosity_options(CLI::App& app, ViewOptions& options, const std::string& group) {
  CLI::Option* quiet = app.add_flag_callback(
      "-q,--quiet", [&options] { options.verbosity = Verbosity::quiet; },
      "Only warnings and errors");
  quiet->group(group);
  app.add_flag_callback(
         "-v,--verbose", [&options] { options.verbosity = Verbosity::verbose; }, "More detail")
      ->group(group)
      ->excludes(quiet);
}

void check_view_options(const ViewOptions& options) {
  if (options.orbit && options.camera) {
    throw UsageError("--orbit and --camera each choose a camera; give one of them");
  }
  if (options.target && !options.orbit) throw UsageError("--target needs --orbit");
  if (options.orbit && !(options.orbit->z > 0.0)) {
    throw UsageError("--orbit: the radius must be above 0");
  }
  if (options.focus && !options.aperture) throw UsageError("--focus needs --aperture");
  if (options.focus && !(*options.focus > 0.0f)) throw UsageError("--focus must be above 0");
}

}  // namespace lume::cli
