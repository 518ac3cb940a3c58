// SPDX-License-Identifier: Apache-2.0
// `lume bench --cost-maps`: where in a picture a structure has much to look at.
#include "io/image_io.h"
#include "renderer/cli/bench_modes.h"
#include "renderer/cli/bench_report.h"
#include "renderer/cli/color_map.h"
#include "renderer/cli/counting.h"
#include "renderer/cli/render_stats.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/text.h"
#include "renderer/render.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace lume::cli {
namespace {

using ColorMap = shading::Color (*)(float);

constexpr int k_default_width = 640;

/// What every pixel's rays cost with one structure, means of its samples.
struct CostMap {
  std::string name;
  std::vector<float> nodes;
  std::vector<float> tests;
};

CostMap make_map(const renderer::Candidate& candidate, const BenchOptions& options,
                 const shading::Scene& scene, const Viewpoint& view) {
  renderer::PreparedScene prepared(scene, candidate.make);
  check_counts_cost("--cost-maps", candidate.name, prepared.accelerator());
  renderer::RenderSettings settings;
  static_cast<renderer::PixelSettings&>(settings) = pixel_settings(options, view.size);
  settings.aovs = {renderer::Aov::nodes, renderer::Aov::primitive_tests};
  // The light is of no interest: the integrator that asks the fewest rays.
  const auto integrator = renderer::make_integrator("raycast", prepared, {.shadows = false});
  renderer::Film film = render_image(prepared, view.camera.camera, *integrator, settings, {}).film;
  return {short_name(candidate.name), std::move(film.layers[0].values),
          std::move(film.layers[1].values)};
}

io::Picture empty_picture(const ImageSize& size) {
  io::Picture picture;
  picture.full_width = size.width;
  picture.full_height = size.height;
  picture.region = {0, 0, size.width, size.height};
  return picture;
}

/// The values in colours, low at 0 of the map and high at 1, and below them the map itself from end
/// to end.
void write_colors(const std::string& file, const std::vector<float>& values, const ImageSize& size,
                  ColorMap color, const std::function<float(float)>& scale, float first_color) {
  const int bar = std::max(4, size.height / 24);
  io::Picture picture = empty_picture({size.width, size.height + bar});
  const auto width = static_cast<std::size_t>(size.width);
  picture.pixels.reserve(width * static_cast<std::size_t>(size.height + bar));
  for (const float value : values) picture.pixels.emplace_back(color(scale(value)), 1.0f);
  for (std::size_t i = 0; i < width * static_cast<std::size_t>(bar); ++i) {
    const bool gap = i / width < static_cast<std::size_t>(bar / 4);
    const float along = static_cast<float>(i % width) / static_cast<float>(width);
    const shading::Color shown =
        gap ? shading::Color(1.0f) : color(first_color + (1.0f - first_color) * along);
    picture.pixels.emplace_back(shown, 1.0f);
  }
  io::WriteOptions write;
  write.view = io::ViewTransform({{}, {}, "Standard"});
  io::write_picture(file, picture, write);
}

void write_values(const std::string& file, const std::vector<float>& nodes,
                  const std::vector<float>& tests, const ImageSize& size) {
  io::Picture picture = empty_picture(size);
  picture.pixels.assign(nodes.size(), shading::Vec4(0.0f));
  picture.layers.push_back({{"nodes.V"}, nodes, true});
  picture.layers.push_back({{"primitive_tests.V"}, tests, true});
  io::write_picture(file, picture, {});
}

/// A value that all but one in two hundred stay below, so that a few glaring pixels do not leave
/// all others dark.
float upper_end(std::vector<float> values) {
  const auto place = static_cast<std::ptrdiff_t>(values.size() - 1 - values.size() / 200);
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return std::max(values[static_cast<std::size_t>(place)], 1.0f);
}

std::vector<float> difference(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::minus<>());
  return result;
}

double mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void write_map(const std::string& prefix, const CostMap& map, const ImageSize& size, float high) {
  const std::string name = prefix + "-" + map.name;
  write_colors(
      name + "-nodes.png", map.nodes, size, sequential_color,
      [high](float value) { return value / high; }, 0.0f);
  write_values(name + ".exr", map.nodes, map.tests, size);
}

/// Returns the number of nodes at the ends of the scale.
float write_difference(const std::string& prefix, const CostMap& a, const CostMap& b,
                       const ImageSize& size) {
  const std::vector<float> nodes = difference(a.nodes, b.nodes);
  std::vector<float> sizes(nodes.size());
  std::transform(nodes.begin(), nodes.end(), sizes.begin(),
                 [](float value) { return std::abs(value); });
  const float high = upper_end(std::move(sizes));
  const std::string name = prefix + "-" + a.name + "-minus-" + b.name;
  write_colors(
      name + "-nodes.png", nodes, size, diverging_color,
      [high](float value) { return value / high; }, -1.0f);
  write_values(name + ".exr", nodes, difference(a.tests, b.tests), size);
  return high;
}

}  // namespace

ExitCode run_cost_maps(const BenchOptions& options) {
  const BenchOptions of_scene = options_for(options, options.scene_files.front(), k_default_width);
  io::LoadedScene loaded = load_scene(of_scene);
  Viewpoint view = choose_viewpoint(loaded.scene, of_scene);
  focus(view, of_scene,
        renderer::PreparedScene(loaded.scene, geometry::accelerator_names().front()));
  std::vector<CostMap> maps;
  maps.reserve(options.accelerators.size());
  for (const auto& candidate : name_candidates(options.accelerators, view, {})) {
    maps.push_back(make_map(candidate, of_scene, loaded.scene, view));
  }
  float high = 1.0f;
  for (const CostMap& map : maps) high = std::max(high, upper_end(map.nodes));

  const std::string& prefix = *options.cost_maps;
  std::string text = fmt::format(
      "{}x{} pixels; all maps of nodes from 0 (violet) to {:.4g} (yellow), the bar below them\n",
      view.size.width, view.size.height, high);
  for (const CostMap& map : maps) {
    write_map(prefix, map, view.size, high);
    text += fmt::format("{}-{}-nodes.png, .exr: on average {:.4g} nodes and {:.4g} tests a pixel\n",
                        printable(prefix), printable(map.name), mean(map.nodes), mean(map.tests));
  }
  for (std::size_t i = 1; i < maps.size(); ++i) {
    const float end = write_difference(prefix, maps[0], maps[i], view.size);
    text += fmt::format(
        "{0}-{1}-minus-{2}-nodes.png, .exr: blue where {1} visits up to {3:.4g} nodes fewer, red "
        "where it visits more\n",
        printable(prefix), printable(maps[0].name), printable(maps[i].name), end);
  }
  print_result(text);
  return ExitCode::success;
}

}  // namespace lume::cli
