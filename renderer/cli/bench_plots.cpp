// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_plots.h"

#include "renderer/cli/svg_writer.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lume::cli {
namespace {

using renderer::Estimate;
using renderer::RayApi;

constexpr double k_names = 150.0;   // width of the column of names (pixels)
constexpr double k_bars = 560.0;    // width of the longest bar
constexpr double k_values = 170.0;  // width of the column of values
constexpr double k_line = 22.0;     // height of a bar with its space
constexpr const char* k_name_style = R"(font-size="12" text-anchor="end")";
constexpr const char* k_text_style = R"(font-size="12")";
/// Legible on a line that runs behind it.
constexpr const char* k_haloed_style =
    R"(font-size="12" stroke="#fff" stroke-width="4" paint-order="stroke")";

/// Okabe and Ito's colours, which most colour-blind people can tell apart, without the yellow that
/// is pale on white.
constexpr std::array k_colors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                 "#E69F00", "#56B4E9", "#000000"};
const char* color_of(std::size_t structure) { return k_colors[structure % k_colors.size()]; }

/// A row of a bar plot.
struct Bar {
  std::string name;
  Estimate value;
  std::string text;
  std::size_t structure = 0;
};

/// What the longest bar stands for. Intervals may be cut off: on a busy machine they are long.
double largest(const std::vector<Bar>& bars) {
  double most = 0.0;
  for (const Bar& bar : bars) most = std::max(most, bar.value.median);
  return most > 0.0 ? most : 1.0;
}

/// Draws the bars from `top` down; returns where they end.
double draw_bars(SvgWriter& svg, const std::vector<Bar>& bars, double scale, double top) {
  double y = top;
  for (const Bar& bar : bars) {
    const double middle = y + 0.5 * k_line;
    svg.text({k_names - 8.0, middle + 4.0}, shorten(bar.name, 20), k_name_style);
    svg.rectangle({k_names, y + 3.0}, scale * bar.value.median, k_line - 6.0,
                  fmt::format(R"(fill="{}")", color_of(bar.structure)));
    const double low = k_names + scale * bar.value.low;
    const double high = std::min(k_names + scale * bar.value.high, k_names + k_bars);
    if (high > low) {
      constexpr const char* k_whisker = R"(stroke="#1a1a1a" stroke-width="1.5")";
      svg.line({low, middle}, {high, middle}, k_whisker);
      svg.line({low, middle - 4.0}, {low, middle + 4.0}, k_whisker);
      const bool whole = high < k_names + k_bars;
      if (whole) svg.line({high, middle - 4.0}, {high, middle + 4.0}, k_whisker);
    }
    svg.text({std::max(k_names + scale * bar.value.median, high) + 8.0, middle + 4.0}, bar.text,
             k_haloed_style);
    y += k_line;
  }
  return y;
}

std::vector<Bar> ratio_bars(const SceneBench& scene, const renderer::RaySetReport& set) {
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < scene.report.structures.size(); ++i) {
    for (const RayApi api : {RayApi::single, RayApi::batch}) {
      const renderer::Timing* timing = find_timing(set, i, api);
      if (timing == nullptr) continue;
      const char* suffix = api == RayApi::batch ? ", by 16" : "";
      bars.push_back({printable(short_name(scene.report.structures[i].name)) + suffix,
                      timing->ratio,
                      fmt::format("{:.2f}  ({:.1f} M rays/s)", timing->ratio.median,
                                  1e-6 * timing->rate.median),
                      i});
    }
  }
  return bars;
}

/// The geometric mean of a structure's single rays a second over the kinds of rays; nothing where
/// there were none. A mean of rates of different kinds says something only as a product.
std::optional<double> mean_rate(const SceneBench& scene, std::size_t structure) {
  double logarithms = 0.0;
  int count = 0;
  for (const auto& set : scene.report.sets) {
    const renderer::Timing* timing = find_timing(set, structure, RayApi::single);
    if (timing == nullptr || !(timing->rate.median > 0.0)) continue;
    logarithms += std::log(timing->rate.median);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return std::exp(logarithms / count);
}

/// A logarithmic or linear axis.
struct Axis {
  double low = 0.0;  ///< of the values
  double high = 1.0;
  double begin = 0.0;  ///< in pixels
  double end = 1.0;

  [[nodiscard]] double place(double value) const {
    return begin + (value - low) / (high - low) * (end - begin);
  }
};

void draw_decades(SvgWriter& svg, const Axis& axis, double top, double bottom) {
  for (int i = 0; axis.low + i <= axis.high; ++i) {
    const double decade = axis.low + i;
    const double x = axis.place(decade);
    svg.line({x, top}, {x, bottom}, R"(stroke="#ddd")");
    svg.text({x, bottom + 16.0}, fmt::format("{:g} ms", std::pow(10.0, decade)),
             R"(font-size="12" text-anchor="middle")");
  }
}

void draw_rates(SvgWriter& svg, const Axis& axis, double left, double right) {
  const double step = std::pow(10.0, std::floor(std::log10(axis.high)));
  const double fine = axis.high / step < 3.0 ? 0.5 * step : step;
  for (int i = 0; fine * i <= axis.high; ++i) {
    const double rate = fine * i;
    const double y = axis.place(rate);
    svg.line({left, y}, {right, y}, R"(stroke="#ddd")");
    svg.text({left - 6.0, y + 4.0}, fmt::format("{:g}", rate), k_name_style);
  }
}

}  // namespace

std::string plot_ratios(const SceneBench& scene) {
  double most = 1.0;
  for (const auto& set : scene.report.sets) most = std::max(most, largest(ratio_bars(scene, set)));
  const double scale = k_bars / (1.2 * most);  // with room for intervals
  SvgWriter svg;
  double y = 4.0;
  for (const auto& set : scene.report.sets) {
    svg.text({k_names, y + 14.0},
             fmt::format("{} ({})", set.name, set.any_hit ? "any hit" : "closest hit"),
             R"(font-size="13" font-weight="bold")");
    const std::vector<Bar> bars = ratio_bars(scene, set);
    const double top = y + k_line;
    svg.line({k_names + scale, top},
             {k_names + scale, top + k_line * static_cast<double>(bars.size())},
             R"(stroke="#1a1a1a" stroke-dasharray="3 3")");
    y = draw_bars(svg, bars, scale, top);
    y += 8.0;
  }
  return svg.inline_element(k_names + k_bars + k_values, y, "Ratios of rays a second");
}

std::string plot_build_against_rays(const SceneBench& scene) {
  constexpr double k_width = 880.0, k_height = 340.0;
  const auto& structures = scene.report.structures;
  const auto milliseconds = [&](std::size_t i) {
    return std::log10(std::max(1e3 * structures[i].one_thread_seconds, 1e-4));
  };
  Axis across{1e9, -1e9, k_names - 80.0, k_width - 130.0};
  Axis up{0.0, 1e-9, k_height - 50.0, 30.0};
  for (std::size_t i = 0; i < structures.size(); ++i) {
    across.low = std::min(across.low, std::floor(milliseconds(i)));
    across.high = std::max(across.high, std::floor(milliseconds(i)) + 1.0);
    up.high = std::max(up.high, 1.1e-6 * mean_rate(scene, i).value_or(0.0));
  }
  SvgWriter svg;
  draw_decades(svg, across, up.end, up.begin);
  draw_rates(svg, up, across.begin, across.end);
  svg.text({across.begin - 40.0, 16.0}, "M rays/s, geometric mean over the kinds of rays",
           k_text_style);
  svg.text({across.end, up.begin + 36.0}, "build, one thread", k_name_style);
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const auto rate = mean_rate(scene, i);
    if (!rate) continue;
    const SvgPoint at{across.place(milliseconds(i)), up.place(1e-6 * *rate)};
    svg.circle(at, 5.0, fmt::format(R"(fill="{}")", color_of(i)));
    svg.text({at.x + 9.0, at.y + 4.0}, shorten(printable(short_name(structures[i].name)), 24),
             k_text_style);
  }
  return svg.inline_element(k_width, k_height, "Build time against rays a second");
}

std::string plot_memory(const SceneBench& scene) {
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < scene.report.structures.size(); ++i) {
    const auto& stats = scene.report.structures[i].stats;
    const double bytes = static_cast<double>(stats.memory_bytes) /
                         static_cast<double>(std::max<std::size_t>(1, stats.primitives));
    bars.push_back({printable(short_name(scene.report.structures[i].name)),
                    {bytes, bytes, bytes},
                    stats.memory_bytes == 0 ? "not told"
                                            : fmt::format("{:.1f} bytes a primitive ({})", bytes,
                                                          format_bytes(stats.memory_bytes)),
                    i});
  }
  SvgWriter svg;
  const double end = draw_bars(svg, bars, k_bars / largest(bars), 4.0);
  return svg.inline_element(k_names + k_bars + k_values + 40.0, end + 4.0, "Bytes a primitive");
}

}  // namespace lume::cli
