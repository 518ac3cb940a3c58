// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_options.h"

#include "geometry/accelerators/accelerator.h"
#include "renderer/bench/ray_sets.h"
#include "renderer/cli/argument_parsing.h"
#include "renderer/cli/distinct_files.h"
#include "renderer/cli/option_kinds.h"
#include "renderer/cli/render_stats.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace lume::cli {
namespace {

constexpr std::uint64_t k_most_rays = std::uint64_t{1} << 26;  // 2 GiB a kind

constexpr std::string_view k_examples = R"(
Every structure answers the same rays, in turns, and is compared with the first one named within each
round: a ratio of 1.20 is a fifth more rays a second. What each column means: docs/bench.md.

Examples:
  lume bench museum.glb
      Embree and the fastest of Lume's own, on every kind of ray.
  lume bench museum.glb --accelerators embree,bvh-sah,kd-tree --html report.html
      Others; a page with plots to hand in.
  lume bench museum.glb --accelerators embree,./mine.so --prove
      Does a structure of your own give the same picture, to the last bit? If not: the first ray.
  lume bench museum.glb --accelerators embree,./mine.so --replay mismatch-mine.so.rays
      That ray alone, for your debugger.
  lume bench museum.glb --accelerators bvh-sah,bvh-median --cost-maps cost
      Where it is dear: pictures of the nodes that each pixel's ray visits.
  lume bench a.glb b.glb --rays primary,ao --count 1000000 --hit-rate 50 --csv table.csv
      Two scenes, a million rays a kind, of which half meet something.

Exit codes: 0 done, 2 wrong command line, 3 scene wrong or not supported, 4 a file cannot be
read or written, 7 structures that should agree do not (--prove, --replay).
)";

std::vector<std::string> ray_names() {
  std::vector<std::string> names;
  for (const renderer::RaySetInfo& info : renderer::ray_set_infos()) names.emplace_back(info.name);
  return names;
}

/// Those worth a race, of those there are.
std::vector<std::string> default_accelerators() {
  constexpr std::array<std::string_view, 4> k_racers = {"embree", "embree-high", "wide", "bvh-sah"};
  const auto known = geometry::accelerator_names();
  std::vector<std::string> names;
  for (const std::string_view name : k_racers) {
    if (std::find(known.begin(), known.end(), name) != known.end()) names.emplace_back(name);
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ","));
}

/// The scenes are many here, and so are the structures.
void replace_single_options(CLI::App& app, BenchOptions& options) {
  app.remove_option(app.get_option("SCENE"));
  app.remove_option(app.get_option("--accelerator"));
  app.add_option("SCENE", options.scene_files, "The scenes: .gltf or .glb files")
      ->type_name("FILE...")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.get_option("--spp")->description("Samples a pixel of --prove and --cost-maps (1)");
  app.get_option("--width")->description("Pixels (1280; 320 with --prove, 640 with --cost-maps)");
  app.get_option("--occlusion")
      ->description(
          "Length of the ao rays, and of ambient occlusion in pictures (ao: a tenth of "
          "the scene)");
}

void add_race_options(CLI::App& app, BenchOptions& options) {
  const std::string group = "Race";
  options.accelerators = default_accelerators();
  add_parsed(
      app, "--accelerators", options.accelerators, parse_accelerators,
      fmt::format("The structures, the baseline first; all, or ./FILE.so for a plugin: {} "
                  "({})",
                  joined(to_strings(geometry::accelerator_names())), joined(options.accelerators)))
      ->type_name("LIST")
      ->group(group);
  options.rays = ray_names();
  add_parsed(
      app, "--rays", options.rays,
      [](const std::string& text) { return parse_names(text, "kind of rays", ray_names()); },
      "Which kinds: " + joined(options.rays) + " (all)")
      ->type_name("LIST")
      ->group(group);
  app.add_option("--count", options.count, fmt::format("Rays of each kind ({})", options.count))
      ->check(whole_between(1, k_most_rays))
      ->type_name("N")
      ->group(group);
  app.add_option("--hit-rate", options.hit_rate,
                 "Choose among the rays so that this share hits something (as it comes)")
      ->check(real_between(0.0, 100.0))
      ->type_name("PERCENT")
      ->group(group);
  app.add_option("--repeat", options.repeat, "Rounds that count (9)")
      ->check(whole_between(1, 1000))
      ->type_name("N")
      ->group(group);
  app.add_option("--threads", options.threads, "Shoot from so many threads at once (1)")
      ->check(whole_between(1, 1024))
      ->type_name("N")
      ->group(group);
  app.add_option("--budget", options.budget,
                 "What one measurement may take; slow structures shoot fewer rays (0.25)")
      ->check(real_between(0.001, 1e5))
      ->type_name("SECONDS")
      ->group(group);
}

void add_instead_options(CLI::App& app, BenchOptions& options) {
  const std::string group = "Instead of a race";
  app.add_flag("--prove", options.prove,
               "Render through every structure and compare the pictures bit by bit")
      ->group(group);
  app.add_option("--save-mismatch", options.save_mismatch,
                 "Where to write a ray that --prove finds (mismatch-NAME.rays)")
      ->check(file_name())
      ->type_name("FILE")
      ->group(group);
  app.add_option("--replay", options.replay, "Shoot the rays of a file, and print what they hit")
      ->check(file_name())
      ->type_name("FILE")
      ->group(group);
  app.add_option("--cost-maps", options.cost_maps,
                 "Draw what each pixel's ray costs: PREFIX-NAME-nodes.png, PREFIX-NAME.exr")
      ->check(file_name())
      ->type_name("PREFIX")
      ->group(group);
}

void add_file_options(CLI::App& app, BenchOptions& options) {
  const std::string group = "Files";
  const auto name_or_dash = [](std::string& text) {
    return text == "-" ? std::string() : file_name()(text);
  };
  app.add_option("--json", options.json, "Write everything for programs; - is stdout")
      ->check(CLI::Validator(name_or_dash, ""))
      ->type_name("FILE")
      ->group(group);
  const auto file = [&](const char* name, std::optional<std::string>& value, const char* help) {
    app.add_option(name, value, help)->check(file_name())->type_name("FILE")->group(group);
  };
  file("--csv", options.csv, "Write a line for each measurement, for a spreadsheet");
  file("--html", options.html, "Write a page with plots and tables; it needs no network");
  file("--save-rays", options.save_rays, "Write the rays that were shot");
  file("--load-rays", options.load_rays, "Shoot the rays of a file");
  add_verbosity_options(app, options, group);
}

void check_modes(const BenchOptions& options) {
  const int modes =
      (options.prove ? 1 : 0) + (options.replay ? 1 : 0) + (options.cost_maps ? 1 : 0);
  if (modes > 1) throw UsageError("--prove, --replay and --cost-maps: one at a time");
  if (options.save_mismatch && !options.prove) throw UsageError("--save-mismatch needs --prove");
  const bool race_files =
      options.json || options.csv || options.html || options.save_rays || options.load_rays;
  if (modes > 0 && race_files) {
    throw UsageError(
        "--json, --csv, --html, --save-rays and --load-rays are for the race, not for --prove, "
        "--replay or --cost-maps");
  }
  const bool one_scene = options.save_rays || options.load_rays || options.replay ||
                         options.cost_maps || options.save_mismatch;
  if (options.scene_files.size() > 1 && one_scene) {
    throw UsageError("rays and pictures in files are of one scene; give one");
  }
}

void check_files(const BenchOptions& options) {
  DistinctFiles files;
  for (const std::string& scene : options.scene_files) files.read("the scene", scene);
  if (options.environment) files.read("--env", *options.environment);
  if (options.load_rays) files.read("--load-rays", *options.load_rays);
  const auto write = [&](const char* role, const std::optional<std::string>& file) {
    if (!file) return;
    files.write(role, *file);
    check_text_writable(*file);
  };
  if (!options.json_to_stdout()) write("--json", options.json);
  write("--csv", options.csv);
  write("--html", options.html);
  write("--save-rays", options.save_rays);
  write("--save-mismatch", options.save_mismatch);
  if (options.cost_maps) check_text_writable(*options.cost_maps + "-map.exr");
}

}  // namespace

std::vector<std::string> parse_accelerators(const std::string& text) {
  const std::vector<std::string> known = to_strings(geometry::accelerator_names());
  std::vector<std::string> names;
  std::istringstream parts(text + ",");
  for (std::string part; std::getline(parts, part, ',');) {
    const bool is_file = part.find('/') != std::string::npos;
    for (const std::string& name :
         is_file ? std::vector{part} : parse_names(part, "accelerator", known)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

void add_bench_options(CLI::App& app, BenchOptions& options) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  options.spp = 1;
  add_view_options(app, options);
  replace_single_options(app, options);
  add_race_options(app, options);
  add_instead_options(app, options);
  add_file_options(app, options);
  app.footer(std::string(k_examples));
}

void check_bench_options(const BenchOptions& options) {
  if (options.scene_files.empty()) {
    throw UsageError("no scene given; try: lume bench SCENE.glb");
  }
  check_view_options(options);
  check_modes(options);
  check_files(options);
}

}  // namespace lume::cli
