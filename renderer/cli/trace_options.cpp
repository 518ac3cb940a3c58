// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/trace_options.h"

#include "io/gltf/write_lines.h"
#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/distinct_files.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <limits>
#include <string_view>

namespace lume::cli {
namespace {

/// Every ray of every sample is kept in memory.
constexpr std::uint32_t k_max_spp = 4096;

constexpr std::string_view k_examples = R"(
The tree is the course's: a camera ray meets a surface; shadow rays ask each light whether it
arrives; a reflected and a refracted ray bring back the rest, each found the same way. Every term of
  I = emitted + L_a k_a O_a + sum over lights f_att L_p [k_d O_d (n.l) + k_s O_s (r.v)^n]
    + k_r O_s I_reflected + k_t O_t I_transmitted
is printed, and the terms add up to the pixel that lume render makes of the same options, to the
last bit.

Examples:
  lume trace glass.gltf --pixel 320,240 --width 640
      The tree of one pixel as text; the pixel is counted from the picture's upper left corner.
  lume trace glass.gltf --pixel 320,240 --width 640 --max-depth 2 --svg tree.svg
      The same two levels deep, and drawn; any browser shows the file.
  lume trace glass.gltf --pixel 320,240 --width 640 --gltf rays.glb
      Its rays as coloured lines; open glass.gltf and rays.glb in one viewer.
  lume trace glass.gltf --pixel 320,240 --width 640 --spp 16 --sample 7
      The eighth of sixteen samples, and the value of all.
  lume trace glass.gltf --pixel 320,240 --json - | jq .value.color
      For programs.

Exit codes: 0 done, 2 wrong command line, 3 scene wrong or not supported, 4 a file cannot be
read or written, 6 infinite or NaN samples.
)";

PixelPlace parse_pixel(const std::string& text) {
  constexpr std::uint64_t k_most = std::numeric_limits<std::uint16_t>::max();
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw UsageError(fmt::format("expected X,Y in pixels, got '{}'", printable(text)));
  }
  const std::string_view view = text;
  return {static_cast<int>(parse_whole(view.substr(0, comma), 0, k_most)),
          static_cast<int>(parse_whole(view.substr(comma + 1), 0, k_most))};
}

void add_pixel_options(CLI::App& app, TraceOptions& options) {
  const std::string group = "Pixel";
  add_parsed(app, "--pixel", options.pixel, parse_pixel,
             "The one to explain; 0,0 is the upper left")
      ->type_name("X,Y")
      ->group(group);
  app.add_option("--sample", options.sample, "Whose tree to show, of --spp; from 0 (0)")
      ->check(whole_between(0, k_max_spp - 1))
      ->type_name("N")
      ->group(group);
}

void add_file_options(CLI::App& app, TraceOptions& options) {
  const std::string group = "Files";
  const auto check_name_or_dash = [](std::string& text) {
    return text == "-" ? std::string() : file_name()(text);
  };
  app.add_option("--json", options.json, "Write all samples for programs; - is stdout")
      ->check(CLI::Validator(check_name_or_dash, ""))
      ->type_name("FILE")
      ->group(group);
  app.add_option("--svg", options.svg, "Draw the tree")
      ->check(file_name())
      ->type_name("FILE")
      ->group(group);
  app.add_option("--gltf", options.gltf,
                 "Write the rays as coloured lines, to lay over the scene: .gltf or .glb")
      ->check(file_name())
      ->type_name("FILE")
      ->group(group);
  add_verbosity_options(app, options, group);
}

void check_files_differ(const TraceOptions& options) {
  DistinctFiles files;
  files.read("the scene", options.scene_file);
  if (options.environment) files.read("--env", *options.environment);
  if (options.json && !options.json_to_stdout()) files.write("--json", *options.json);
  if (options.svg) files.write("--svg", *options.svg);
  if (options.gltf) files.write("--gltf", *options.gltf);
}

}  // namespace

void add_trace_options(CLI::App& app, TraceOptions& options) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  options.spp = 1;
  add_view_options(app, options);
  app.get_option("--spp")->description("Samples a pixel (1)");
  add_pixel_options(app, options);
  add_file_options(app, options);
  app.footer(std::string(k_examples));
}

void check_trace_options(const TraceOptions& options) {
  if (options.scene_file.empty()) {
    throw UsageError("no scene given; try: lume trace SCENE.glb --pixel 640,360");
  }
  if (!options.pixel) {
    throw UsageError(fmt::format("no pixel given; try: lume trace {} --pixel 640,360",
                                 shell_quote(printable(options.scene_file))));
  }
  check_view_options(options);
  if (options.spp > k_max_spp) {
    throw UsageError(fmt::format(
        "--spp: every ray of every sample is kept, which is possible for up to {} samples",
        k_max_spp));
  }
  if (options.sample >= options.spp) {
    throw UsageError(fmt::format("--sample: {} is not one of {} sample{}, which count from 0",
                                 options.sample, options.spp, options.spp == 1 ? "" : "s"));
  }
  check_files_differ(options);
  if (options.json && !options.json_to_stdout()) check_text_writable(*options.json);
  if (options.svg) check_text_writable(*options.svg);
  if (options.gltf) {
    io::check_lines_name(*options.gltf);
    check_text_writable(*options.gltf);
  }
}

}  // namespace lume::cli
