// SPDX-License-Identifier: Apache-2.0
// The options of `lume render`, group by group, as its help shows them.
#include "renderer/cli/render_options.h"

#include "geometry/accelerators/accelerator.h"
#include "io/color.h"
#include "renderer/aov.h"
#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/exit_codes.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"
#include "renderer/integrator.h"
#include "renderer/pixel_filter.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <exception>
#include <functional>
#include <limits>
#include <string_view>

namespace lume::cli {
namespace {

constexpr double k_max_coordinate = 1e12;  // metres; beyond it even doubles lose the millimetres
constexpr double k_max_angle = 36000.0;    // degrees
constexpr std::uint64_t k_max_side = 65535;

/// An option whose text `parse` turns into the value. Its complaints get the option's name.
template <class T, class Parse>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, T& value, Parse parse,
                        const std::string& help) {
  const std::function<void(const std::string&)> store = [name, &value,
                                                         parse](const std::string& text) {
    try {
      value = parse(text);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{}: {}", name, error.what()));
    }
  };
  return app.add_option_function(name, store, help);
}

std::vector<std::string> aov_names() {
  std::vector<std::string> names;
  for (const renderer::AovInfo& info : renderer::aov_infos()) names.emplace_back(info.name);
  return names;
}

/// An option with one of a few names; the first one is the default.
void add_choice(CLI::App& app, const std::string& option, std::string& value,
                const std::string& what, const std::vector<std::string>& names,
                const std::string& group) {
  if (value.empty()) value = names.front();
  app.add_option(option, value, fmt::format("{} ({})", list_names(names), value))
      ->check(one_of(what, names))
      ->type_name("NAME")
      ->group(group);
}

void add_input_options(CLI::App& app, RenderOptions& options) {
  app.add_option("SCENE", options.scene_file, "The scene: a .gltf or .glb file")->type_name("FILE");
  app.add_option("-o,--output", options.outputs,
                 "Write a picture; its extension chooses the format. Repeats.")
      ->type_name("FILE")
      ->type_size(1)
      ->allow_extra_args(false)
      ->check(file_name())
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--scene", options.scene, "Which scene of the file (the file's default)")
      ->type_name("NAME|N");
  app.add_flag("--tessellated", options.tessellated,
               "Draw the triangles that stand in for analytic shapes in other viewers, instead "
               "of the shapes");
}

void add_camera_options(CLI::App& app, RenderOptions& options) {
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
}

void add_picture_options(CLI::App& app, RenderOptions& options) {
  const std::string group = "Picture";
  app.add_option("--width", options.width, "Pixels (1280, or by the camera's shape)")
      ->check(whole_between(1, k_max_side))
      ->type_name("N")
      ->group(group);
  app.add_option("--height", options.height, "Pixels (by the camera's shape, or 16:9)")
      ->check(whole_between(1, k_max_side))
      ->type_name("N")
      ->group(group);
  add_parsed(app, "--crop", options.crop, parse_crop, "Render this part of the picture only")
      ->type_name("WxH+X+Y")
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
  add_parsed(
      app, "--aov", options.aovs,
      [](const std::string& text) { return parse_names(text, "AOV", aov_names()); },
      fmt::format("More layers for EXR files: all, or of {}", list_names(aov_names())))
      ->type_name("LIST")
      ->group(group);
}

void add_method_options(CLI::App& app, RenderOptions& options) {
  const std::string group = "Method";
  add_choice(app, "--integrator", options.integrator, "integrator",
             to_strings(renderer::integrator_names()), group);
  app.add_option("--max-depth", options.max_depth, "Reflections and refractions in a row (5)")
      ->check(whole_between(0, 100))  // each one is a level of recursion on the stack
      ->type_name("N")
      ->group(group);
  add_choice(app, "--accelerator", options.accelerator, "accelerator",
             to_strings(geometry::accelerator_names()), group);
  app.add_option("--threads", options.threads, "0: one for each core (0)")
      ->check(whole_between(0, 1024))
      ->type_name("N")
      ->group(group);
}

void add_light_options(CLI::App& app, RenderOptions& options) {
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
}

void add_output_options(CLI::App& app, RenderOptions& options) {
  const std::string group = "Display and files";
  app.add_option("--exposure", options.exposure, "Display formats show light * 2^EV (0)")
      ->check(real_between(-64.0, 64.0))
      ->type_name("EV")
      ->group(group);
  app.add_option("--display", options.display, "Which display display formats are made for")
      ->type_name("NAME")
      ->group(group);
  app.add_option("--view", options.view, "How scene light becomes display light (listed below)")
      ->type_name("NAME")
      ->group(group);
  app.add_option("--ocio", options.ocio, "An OpenColorIO configuration ($OCIO, or Lume's own)")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--float", options.full_float, "32-bit instead of 16-bit EXR")->group(group);
  add_choice(app, "--compression", options.compression, "EXR compression",
             {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"}, group);
  app.add_option("--quality", options.jpeg_quality, "Of JPEG files, 1 to 100 (95)")
      ->check(whole_between(1, 100))
      ->type_name("N")
      ->group(group);
}

void add_report_options(CLI::App& app, RenderOptions& options) {
  const std::string group = "Reports";
  app.add_option("--stats", options.stats, "Write times, rays and memory as JSON")
      ->type_name("FILE")
      ->group(group);
  CLI::Option* quiet = app.add_flag_callback(
      "-q,--quiet", [&options] { options.verbosity = Verbosity::quiet; },
      "Only warnings and errors");
  quiet->group(group);
  app.add_flag_callback(
         "-v,--verbose", [&options] { options.verbosity = Verbosity::verbose; }, "More detail")
      ->group(group)
      ->excludes(quiet);
}

std::string views_text(const std::string& config) {
  std::string text = "Displays and their views:\n";
  try {
    for (const io::DisplayViews& display : io::available_views(config)) {
      text += fmt::format("  {}: {}\n", printable(display.display), list_names(display.views));
    }
  } catch (const std::exception& error) {
    text += fmt::format("  not known: {}\n", printable(error.what()));
  }
  return text;
}

constexpr std::string_view k_examples = R"(
Examples:
  lume render helmet.glb -o helmet.png
      The file's first camera, or one that frames the scene; Khronos PBR Neutral tone mapping.
  lume render helmet.glb -o helmet.exr -o helmet.png --env studio.hdr --spp 256
      Scene-linear EXR and a PNG of the same render, lit by an environment.
  lume render helmet.glb -o side.png --orbit 90,80,3 --target 0,0.5,0 --fov 30 --width 800
      From the +x side, slightly above, three metres from the target.
  lume render helmet.glb -o layers.exr --aov depth,normal,albedo --float
      More layers for compositing, all in 32 bits.
  lume render helmet.glb -o part.png --width 3840 --crop 640x360+1600+900
      A part of a large picture, with the same pixels as in the whole.

An option given twice counts as given last; -o repeats.
#### in an output's name becomes the frame's number: picture.####.exr is written as
picture.0001.exr.

Exit codes: 0 done, 2 wrong command line, 3 scene wrong or not supported, 4 a file cannot be
read or written, 6 infinite or NaN samples, 130 interrupted (what was done is written).
)";

}  // namespace

void add_render_options(CLI::App& app, RenderOptions& options) {
  // Scripts put their defaults first and the user's arguments after them.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  add_input_options(app, options);
  add_camera_options(app, options);
  add_picture_options(app, options);
  add_method_options(app, options);
  add_light_options(app, options);
  add_output_options(app, options);
  add_report_options(app, options);
  app.footer([&options] { return views_text(options.ocio) + std::string(k_examples); });
}

}  // namespace lume::cli
