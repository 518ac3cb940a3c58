// SPDX-License-Identifier: Apache-2.0
// The options of `lume render`, group by group, as its help shows them.
#include "renderer/cli/render_options.h"

#include "io/color.h"
#include "renderer/aov.h"
#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/suggest.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <exception>
#include <functional>
#include <limits>
#include <string_view>

namespace lume::cli {
namespace {

std::vector<std::string> aov_names() {
  std::vector<std::string> names;
  for (const renderer::AovInfo& info : renderer::aov_infos()) names.emplace_back(info.name);
  return names;
}

/// All means all that every accelerator can tell.
std::vector<std::string> parse_aovs(const std::string& text) {
  if (text != "all") return parse_names(text, "AOV", aov_names());
  std::vector<std::string> names;
  for (const renderer::AovInfo& info : renderer::aov_infos()) {
    if (!is_of_cost(info.aov)) names.emplace_back(info.name);
  }
  return names;
}

void add_part_options(CLI::App& app, RenderOptions& options) {
  app.add_option("-o,--output", options.outputs,
                 "Write a picture; its extension chooses the format. Repeats.")
      ->type_name("FILE")
      ->type_size(1)
      ->allow_extra_args(false)
      ->check(file_name())
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  const std::string group = "Picture";
  add_parsed(app, "--crop", options.crop, parse_crop, "Render this part of the picture only")
      ->type_name("WxH+X+Y")
      ->group(group);
  add_parsed(app, "--aov", options.aovs, parse_aovs,
             fmt::format("More layers for EXR files: all, or of {}", fmt::join(aov_names(), ", ")))
      ->type_name("LIST")
      ->group(group);
  app.add_option("--threads", options.threads, "0: one for each core (0)")
      ->check(whole_between(0, 1024))
      ->type_name("N")
      ->group("Method");
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
  add_verbosity_options(app, options, group);
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
  lume render gems.gltf -o gems.png --max-depth 10 --cutoff 0 --spp 64
      Mirrors in mirrors ten levels deep, and no ray left out because it counts for little.
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
  add_view_options(app, options);
  add_part_options(app, options);
  add_output_options(app, options);
  add_report_options(app, options);
  app.footer([&options] { return views_text(options.ocio) + std::string(k_examples); });
}

}  // namespace lume::cli
