// SPDX-License-Identifier: Apache-2.0
// `lume check`: what is wrong or suspicious about a scene, before time is spent on rendering it.
#include "renderer/cli/check_report.h"
#include "renderer/cli/commands.h"
#include "renderer/cli/log.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/result_output.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace lume::cli {
namespace {

using io::check::Severity;

struct CheckOptions {
  std::string scene_file;
  std::string fail_on;
  bool json = false;
};

const std::vector<std::string> k_levels = {"error", "warning", "advice"};

Severity level_of(const std::string& name) {
  return static_cast<Severity>(std::find(k_levels.begin(), k_levels.end(), name) -
                               k_levels.begin());
}

ExitCode verdict(const std::vector<io::check::Finding>& findings, Severity fail_on) {
  ExitCode code = ExitCode::success;
  for (const io::check::Finding& finding : findings) {
    if (finding.severity == Severity::error) return ExitCode::scene;
    if (finding.severity <= fail_on) code = ExitCode::differs;
  }
  return code;
}

ExitCode run_check(const CheckOptions& options) {
  start_log(Verbosity::normal);
  if (options.scene_file.empty()) {
    throw UsageError("no scene given; try: lume check SCENE.glb");
  }
  const std::vector<io::check::Finding> findings = io::check::check_scene(options.scene_file);
  print_result(options.json ? check_to_json(findings, options.scene_file)
                            : check_to_text(findings, options.scene_file));
  return verdict(findings, level_of(options.fail_on));
}

}  // namespace

Command add_check_command(CLI::App& parent) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* app = parent.add_subcommand("check", "Tell what is wrong or suspicious about a scene");
  app->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app->add_option("SCENE", options->scene_file, "The scene: a .gltf or .glb file")
      ->type_name("FILE");
  app->add_flag("--json", options->json, "For programs: JSON instead of text");
  add_choice(*app, "--fail-on", options->fail_on, "level", k_levels, "");
  app->footer(R"(
Exit code: 0 if nothing is as bad as --fail-on says, 1 if something is, 3 if Lume
refuses the file, 4 if it cannot be read.

Examples:
  lume check lamp.glb
      What Lume would refuse, leave out or draw otherwise than was probably meant,
      with the place in the file and what to do about it.
  lume check lamp.glb --fail-on warning --json > lamp.json
      A gate in a pipeline: fails on warnings too.
)");
  return {app, [options] { return run_check(*options); }};
}

}  // namespace lume::cli
