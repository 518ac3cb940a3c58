// SPDX-License-Identifier: Apache-2.0
// `lume render`: from a scene's file to pictures.
#include "geometry/parallel.h"
#include "renderer/cli/commands.h"
#include "renderer/cli/interrupt.h"
#include "renderer/cli/output_name.h"
#include "renderer/cli/progress.h"
#include "renderer/cli/render_options.h"
#include "renderer/cli/render_setup.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/replay.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <utility>

namespace lume::cli {
namespace {

constexpr int k_single_frame = 1;

renderer::RenderResult trace_watched(const RenderSetup& setup, const RenderOptions& options) {
  Progress progress(stderr, options.verbosity == Verbosity::quiet ? Progress::Style::none
                                                                  : Progress::style_for(stderr));
  const Stopwatch watch;
  renderer::RenderControl control;
  control.on_progress = [&](double fraction) { progress.update(fraction, watch.elapsed()); };
  control.cancel = &InterruptGuard::flag();
  return trace(setup, options, control);
}

void write_pictures(const RenderOptions& options, const io::WriteOptions& write,
                    const io::Picture& picture) {
  for (const std::string& output : options.outputs) {
    const std::filesystem::path path = frame_path(output, k_single_frame);
    io::write_picture(path, picture, write);
    spdlog::info("wrote {}", printable(path.string()));
  }
}

void log_plan(const RenderOptions& options, const RenderSetup& setup, unsigned threads) {
  const Viewpoint& viewpoint = setup.viewpoint;
  const shading::PixelRegion& region = setup.settings.region;
  const std::string part = options.crop ? fmt::format(" (of it {}x{}+{}+{})", region.width,
                                                      region.height, region.x, region.y)
                                        : "";
  spdlog::info("camera: {}; light: {}", viewpoint.camera.description, setup.light);
  spdlog::info("{}x{} pixels{}, {} samples each, {} on {}, {} thread{}", viewpoint.size.width,
               viewpoint.size.height, part, options.spp, options.integrator, options.accelerator,
               threads, threads == 1 ? "" : "s");
}

void log_unsampled_emitters(const shading::Scene& scene) {
  const std::vector<geometry::Hit> emitters = renderer::unsampled_emitters(scene);
  if (emitters.empty()) return;
  spdlog::info(
      "note: {} emissive surfaces (a {}) are seen but light nothing; meshes, spheres, rectangles "
      "and "
      "disks do",
      emitters.size(), geometry::shape_name(*scene.world.geometry(emitters.front()).shape()));
}

void log_stats(const RenderStats& stats) {
  spdlog::info("rendered in {}: {} rays, {:.2f} million a second",
               format_duration(stats.render_seconds), format_count(stats.rays.total()),
               stats.rays_per_second() * 1e-6);
  spdlog::debug("loading {}, building {}, writing {}, at most {} of memory",
                format_duration(stats.load_seconds), format_duration(stats.build_seconds),
                format_duration(stats.write_seconds), format_bytes(peak_memory_bytes()));
}

ExitCode judge(const RenderOptions& options, const renderer::NonFiniteSamples& non_finite,
               bool interrupted) {
  if (non_finite.count > 0) {
    spdlog::warn(
        "{} samples are infinite or NaN and count as black; the first is sample {} of "
        "pixel ({}, {}); replay it with: {}",
        format_count(non_finite.count), non_finite.sample, non_finite.x, non_finite.y,
        replay_command(options.arguments, non_finite.x, non_finite.y));
  }
  if (interrupted) {
    spdlog::warn("interrupted; what was done is written");
    return ExitCode::interrupted;
  }
  return non_finite.count > 0 ? ExitCode::non_finite : ExitCode::success;
}

ExitCode run_render(const RenderOptions& options) {
  start_log(options.verbosity);
  check_render_options(options);
  const io::WriteOptions write = prepare_outputs(options);
  const InterruptGuard interrupt(options.verbosity != Verbosity::quiet);
  const geometry::ThreadLimit limit(options.threads);

  RenderStats stats;
  Stopwatch watch;
  RenderSetup setup;
  load(setup, options);
  stats.load_seconds = watch.lap();

  build(setup, options);
  stats.build_seconds = watch.lap();
  if (InterruptGuard::flag()) {
    spdlog::warn("interrupted before there was a picture; nothing is written");
    return ExitCode::interrupted;
  }

  if (setup.loaded.scene.world.instances.empty()) {
    spdlog::warn("{} has no surfaces to show; only the backdrop is rendered",
                 printable(options.scene_file));
  }
  aim(setup, options);
  log_unsampled_emitters(setup.loaded.scene);
  log_plan(options, setup, limit.threads());
  renderer::RenderResult result = trace_watched(setup, options);
  stats.render_seconds = watch.lap();

  const io::Picture picture = develop(setup, options, result, write);
  write_pictures(options, write, picture);
  stats.write_seconds = watch.lap();

  stats.rays = result.rays;
  stats.non_finite_samples = result.non_finite.count;
  stats.threads = limit.threads();
  stats.width = setup.viewpoint.size.width;
  stats.height = setup.viewpoint.size.height;
  stats.interrupted = result.cancelled;
  log_stats(stats);
  if (options.stats) write_text(*options.stats, stats_to_json(stats, options));
  return judge(options, result.non_finite, result.cancelled);
}

}  // namespace

Command add_render_command(CLI::App& parent, std::vector<std::string> arguments) {
  // Shared with the closure, which outlives this function.
  const auto options = std::make_shared<RenderOptions>();
  options->arguments = std::move(arguments);
  CLI::App* app = parent.add_subcommand("render", "Render a glTF scene to pictures");
  add_render_options(*app, *options);
  return {app, [options] { return run_render(*options); }};
}

}  // namespace lume::cli
