// SPDX-License-Identifier: Apache-2.0
// `lume info`: what a scene's file holds, and how much of it Lume understands.
#include "renderer/cli/commands.h"
#include "renderer/cli/info_report.h"
#include "renderer/cli/log.h"
#include "renderer/cli/result_output.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace lume::cli {
namespace {

struct InfoOptions {
  std::string scene_file;
  std::optional<std::string> scene;
  bool json = false;
};

ExitCode run_info(const InfoOptions& options) {
  start_log(Verbosity::normal);
  if (options.scene_file.empty()) {
    throw UsageError("no scene given; try: lume info SCENE.glb");
  }
  io::LoadOptions load;
  load.scene = options.scene;
  load.decode_images = false;
  const io::LoadedScene loaded = io::load_gltf(options.scene_file, load);
  print_result(options.json ? info_to_json(loaded, options.scene_file)
                            : info_to_text(loaded, options.scene_file));
  return ExitCode::success;
}

}  // namespace

Command add_info_command(CLI::App& parent) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* app = parent.add_subcommand("info", "Tell what a glTF file holds");
  app->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app->add_option("SCENE", options->scene_file, "The scene: a .gltf or .glb file")
      ->type_name("FILE");
  app->add_option("--scene", options->scene, "Which scene of the file (the file's default)")
      ->type_name("NAME|N");
  app->add_flag("--json", options->json, "For programs: JSON instead of text");
  app->footer(R"(
Examples:
  lume info helmet.glb
      Counts, bounds, cameras, lights, materials, extensions and memory.
  lume info helmet.glb --json | jq .counts.triangles
      One of them, for a script.
)");
  return {app, [options] { return run_info(*options); }};
}

}  // namespace lume::cli
