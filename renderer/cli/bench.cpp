// SPDX-License-Identifier: Apache-2.0
// `lume bench`: acceleration structures compared over the same rays.
#include "renderer/bench/bench.h"

#include "geometry/accelerators/accelerator.h"
#include "io/ray_file.h"
#include "renderer/bench/hit_rate.h"
#include "renderer/cli/bench_modes.h"
#include "renderer/cli/bench_report.h"
#include "renderer/cli/commands.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/scene_counts.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace lume::cli {
namespace {

using renderer::RaySet;

constexpr int k_default_width = 1280;

/// Whose answers count as right: a structure by exact rules that is not Embree's, nor unknown, nor
/// too slow to be asked.
std::string choose_reference(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const bool is_embree = name.starts_with("embree");
    const bool is_plugin = name.find('/') != std::string::npos;
    if (!is_embree && !is_plugin && name != "brute-force") return name;
  }
  const auto known = geometry::accelerator_names();
  const bool has_bvh = std::find(known.begin(), known.end(), "bvh-sah") != known.end();
  return has_bvh ? "bvh-sah" : std::string(known.front());
}

std::vector<RaySet> load_rays(const std::string& file) {
  std::vector<RaySet> sets;
  for (io::RayList& list : io::read_rays(file)) {
    sets.push_back({std::move(list.name), list.any_hit, list.coherent, std::move(list.rays)});
  }
  return sets;
}

void save_rays(const std::string& file, const std::vector<RaySet>& sets) {
  std::vector<io::RayList> lists;
  lists.reserve(sets.size());
  for (const RaySet& set : sets) {
    lists.push_back({set.name, set.any_hit, set.coherent, set.rays});
  }
  io::write_rays(file, lists);
  spdlog::info("wrote {}", printable(file));
}

std::vector<RaySet> record(const BenchOptions& options, const Viewpoint& view,
                           const renderer::PreparedScene& prepared) {
  std::vector<renderer::RaySetKind> kinds;
  for (const renderer::RaySetInfo& info : renderer::ray_set_infos()) {
    const bool asked =
        std::find(options.rays.begin(), options.rays.end(), info.name) != options.rays.end();
    if (asked) kinds.push_back(info.kind);
  }
  const renderer::RaySetSettings settings{options.count, view.size.width, view.size.height,
                                          options.seed, options.occlusion_distance};
  return renderer::record_rays(prepared, view.camera.camera, settings, kinds);
}

void choose_hit_rate(const BenchOptions& options, const geometry::Accelerator& accelerator,
                     std::vector<RaySet>& sets) {
  if (!options.hit_rate) return;
  for (RaySet& set : sets) {
    const renderer::HitCounts recorded = keep_hit_rate(set, accelerator, 0.01 * *options.hit_rate);
    if (!set.rays.empty() || recorded.total() == 0) continue;
    throw UsageError(fmt::format(
        "--hit-rate: {:g}% is impossible, for of {} {} rays {} hit something and {} do not",
        *options.hit_rate, format_count(recorded.total()), set.name, format_count(recorded.hits),
        format_count(recorded.misses)));
  }
}

std::vector<RaySet> make_rays(const BenchOptions& options, const Viewpoint& view,
                              const renderer::PreparedScene& prepared) {
  std::vector<RaySet> sets =
      options.load_rays ? load_rays(*options.load_rays) : record(options, view, prepared);
  choose_hit_rate(options, prepared.accelerator(), sets);
  for (const RaySet& set : sets) {
    if (!set.rays.empty()) continue;
    spdlog::warn("{}: there are no {} rays, for the camera sees nothing that they could start from",
                 printable(options.scene_file), printable(set.name));
  }
  if (options.save_rays) save_rays(*options.save_rays, sets);
  return sets;
}

renderer::BenchSettings bench_settings(const BenchOptions& options) {
  renderer::BenchSettings settings;
  settings.measure.rounds = options.repeat;
  settings.measure.threads = options.threads;
  settings.measure.budget_seconds = options.budget;
  settings.measure.seed = options.seed;
  settings.agreement.rays = std::min(settings.agreement.rays, options.count);
  settings.agreement.budget_seconds = 4.0 * options.budget;
  settings.leak_rays = std::min(settings.leak_rays, options.count);
  return settings;
}

SceneBench race(const BenchOptions& options) {
  io::LoadedScene loaded = load_scene(options);
  Viewpoint view = choose_viewpoint(loaded.scene, options);
  const std::string reference = choose_reference(options.accelerators);
  const renderer::PreparedScene prepared(loaded.scene, reference);
  focus(view, options, prepared);
  const std::vector<RaySet> sets = make_rays(options, view, prepared);

  Progress progress(stderr, bench_progress_style(options));
  const Stopwatch watch;
  renderer::BenchSettings settings = bench_settings(options);
  settings.on_progress = [&](double fraction) { progress.update(fraction, watch.elapsed()); };
  const SceneCounts counts = count_scene(loaded.scene);
  return {options.scene_file,
          options.load_rays ? "" : view.camera.description,
          view.size,
          counts.triangles,
          counts.shapes,
          loaded.scene.world.instances.size(),
          reference,
          run_bench(prepared, name_candidates(options.accelerators, view, {.native_hits = true}),
                    sets, settings)};
}

void write_files(const BenchDocument& document) {
  const BenchOptions& options = document.options;
  const auto write = [](const std::optional<std::string>& file, const auto& make) {
    if (!file) return;
    write_text(*file, make());
    spdlog::info("wrote {}", printable(*file));
  };
  if (!options.json_to_stdout()) write(options.json, [&] { return bench_to_json(document); });
  write(options.csv, [&] { return bench_to_csv(document); });
  write(options.html, [&] { return bench_to_html(document); });
}

ExitCode run_race(const BenchOptions& options) {
  BenchDocument document{options, this_machine(), {}};
  document.scenes.reserve(options.scene_files.size());
  for (const std::string& file : options.scene_files) {
    document.scenes.push_back(race(options_for(options, file, k_default_width)));
  }
  write_files(document);
  print_result(options.json_to_stdout() ? bench_to_json(document) : bench_to_text(document));
  return ExitCode::success;
}

ExitCode run_bench_command(const BenchOptions& options) {
  start_log(options.verbosity);
  check_bench_options(options);
  if (options.prove) return run_prove(options);
  if (options.replay) return run_replay(options);
  if (options.cost_maps) return run_cost_maps(options);
  return run_race(options);
}

}  // namespace

Command add_bench_command(CLI::App& parent, std::vector<std::string> arguments) {
  // Shared with the closure, which outlives this function.
  const auto options = std::make_shared<BenchOptions>();
  options->arguments = std::move(arguments);
  CLI::App* app = parent.add_subcommand("bench", "Compare acceleration structures");
  add_bench_options(*app, *options);
  return {app, [options] { return run_bench_command(*options); }};
}

}  // namespace lume::cli
