// SPDX-License-Identifier: Apache-2.0
// `lume trace`: why a pixel has the colour it has.
#include "renderer/cli/commands.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/text.h"
#include "renderer/cli/trace_report.h"
#include "renderer/cli/view.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace lume::cli {
namespace {

void check_pixel(const PixelPlace& pixel, const ImageSize& size) {
  if (pixel.x < size.width && pixel.y < size.height) return;
  throw UsageError(fmt::format("--pixel: {},{} lies outside the picture of {}x{} pixels", pixel.x,
                               pixel.y, size.width, size.height));
}

renderer::PixelTrace trace(const renderer::PreparedScene& prepared, const TraceOptions& options,
                           const Viewpoint& viewpoint) {
  const auto integrator =
      renderer::make_integrator(options.integrator, prepared, integrator_settings(options));
  renderer::PixelTrace result = renderer::trace_pixel(viewpoint.camera.camera, *integrator,
                                                      pixel_settings(options, viewpoint.size),
                                                      options.pixel->x, options.pixel->y);
  if (adds_up(result)) return result;
  throw std::logic_error(fmt::format(
      "internal: the terms of pixel {},{} do not add up to its value; please report this",
      options.pixel->x, options.pixel->y));
}

void write_files(const TraceReport& report) {
  const TraceOptions& options = report.options;
  const auto say = [](const std::string& file) { spdlog::info("wrote {}", printable(file)); };
  if (options.json && !options.json_to_stdout()) {
    write_text(*options.json, trace_to_json(report));
    say(*options.json);
  }
  if (options.svg) {
    write_text(*options.svg, trace_to_svg(report));
    say(*options.svg);
  }
  if (options.gltf) {
    io::write_lines(*options.gltf, trace_to_lines(report), report.scene.origin);
    say(*options.gltf);
  }
}

ExitCode judge(const renderer::PixelTrace& trace) {
  const auto is_finite = [](const renderer::Radiance& sum) {
    return geometry::is_finite(sum.color()) && std::isfinite(sum.alpha);
  };
  const auto count = std::count_if(trace.sums.begin(), trace.sums.end(), std::not_fn(is_finite));
  if (count == 0) return ExitCode::success;
  spdlog::warn("{} of {} samples are infinite or NaN and count as black", count, trace.sums.size());
  return ExitCode::non_finite;
}

ExitCode run_trace(const TraceOptions& options) {
  start_log(options.verbosity);
  check_trace_options(options);
  io::LoadedScene loaded = load_scene(options);
  Viewpoint viewpoint = choose_viewpoint(loaded.scene, options);
  check_pixel(*options.pixel, viewpoint.size);
  const std::string light = light_scene(options, loaded.scene);
  renderer::PreparedScene prepared(loaded.scene, options.accelerator);
  focus(viewpoint, options, prepared);
  prepared.prepare_view(viewpoint.camera.camera, viewpoint.size.width, viewpoint.size.height);

  const TraceReport report{options,        loaded.scene,
                           viewpoint.size, viewpoint.camera.description,
                           light,          trace(prepared, options, viewpoint)};
  write_files(report);
  print_result(options.json_to_stdout() ? trace_to_json(report) : trace_to_text(report));
  return judge(report.trace);
}

}  // namespace

Command add_trace_command(CLI::App& parent) {
  // Shared with the closure, which outlives this function.
  const auto options = std::make_shared<TraceOptions>();
  CLI::App* app = parent.add_subcommand("trace", "Explain a pixel by the tree of its rays");
  add_trace_options(*app, *options);
  return {app, [options] { return run_trace(*options); }};
}

}  // namespace lume::cli
