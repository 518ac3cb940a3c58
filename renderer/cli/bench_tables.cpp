// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_report.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace lume::cli {
namespace {

using renderer::Estimate;
using renderer::RayApi;
using renderer::RaySetReport;
using renderer::StructureReport;
using renderer::Timing;

const std::string k_unknown = "-";

/// A number with three digits that count: 0.0123, 1.23, 12.3, 123, 1,234.
std::string short_number(double value) {
  if (value >= 1000.0) return format_count(static_cast<std::uint64_t>(std::llround(value)));
  if (value >= 99.95) return fmt::format("{:.0f}", value);
  if (value >= 9.995) return fmt::format("{:.1f}", value);
  if (value >= 0.9995 || value == 0.0) return fmt::format("{:.2f}", value);
  return fmt::format("{:#.3g}", value);
}

std::string interval(const Estimate& estimate, double scale) {
  return short_number(scale * estimate.low) + ".." + short_number(scale * estimate.high);
}

std::string count_or_unknown(std::size_t count) {
  return count == 0 ? k_unknown : format_count(count);
}

/// "0" is none at all; what is below one in a million is not.
std::string rate_of(std::size_t count, std::size_t of) {
  if (of == 0) return k_unknown;
  return count == 0 ? "0" : short_number(per_million(count, of));
}

std::vector<std::string> structure_row(const StructureReport& structure) {
  const geometry::StructureStats& stats = structure.stats.structure;
  const auto primitives = static_cast<double>(std::max<std::size_t>(1, structure.stats.primitives));
  constexpr double k_nothing_built = 1e-6;  // seconds: brute force
  const auto speed = [&](double seconds) {
    return seconds < k_nothing_built ? k_unknown : short_number(1e-6 * primitives / seconds);
  };
  const std::size_t missed = std::max(structure.leaks.missed_closest, structure.leaks.missed_any);
  return {printable(structure.name),
          short_number(1e3 * structure.one_thread_seconds),
          short_number(1e3 * structure.all_threads_seconds),
          speed(structure.one_thread_seconds),
          speed(structure.all_threads_seconds),
          structure.stats.memory_bytes == 0
              ? k_unknown
              : short_number(static_cast<double>(structure.stats.memory_bytes) / primitives),
          count_or_unknown(stats.nodes),
          count_or_unknown(stats.leaves),
          count_or_unknown(stats.depth),
          stats.references == 0 ? k_unknown
                                : short_number(static_cast<double>(stats.references) / primitives),
          stats.sah_cost == 0.0 ? k_unknown : short_number(stats.sah_cost),
          rate_of(missed, structure.leaks.rays)};
}

TextTable structure_table(const SceneBench& scene) {
  const unsigned threads = scene.report.build_threads;
  const std::string all = fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
  TextTable table{"structures",
                  {"structure", "build ms\n1 thread", "build ms\n" + all, "M prims/s\n1 thread",
                   "M prims/s\n" + all, "bytes/\nprim", "nodes", "leaves", "depth", "refs/\nprim",
                   "SAH\ncost", "leaks/M"},
                  {}};
  table.rows.reserve(scene.report.structures.size());
  for (const StructureReport& structure : scene.report.structures) {
    table.rows.push_back(structure_row(structure));
  }
  return table;
}

std::vector<std::string> timing_row(const SceneBench& scene, const RaySetReport& set,
                                    const Timing& timing) {
  const std::size_t i = timing.structure;
  const auto& cost = set.costs[i];
  const renderer::Agreement& agreement = set.agreement[i];
  const bool single = timing.api == RayApi::single;
  std::vector<std::string> row = {
      printable(scene.report.structures[i].name), single ? "single" : "by 16",
      short_number(1e-6 * timing.rate.median),    interval(timing.rate, 1e-6),
      short_number(timing.ratio.median),          interval(timing.ratio, 1.0)};
  // What is looked at and answered was asked ray by ray.
  row.push_back(single && cost ? short_number(cost->nodes) : "");
  row.push_back(single && cost ? short_number(cost->primitive_tests) : "");
  row.push_back(single ? rate_of(agreement.mismatches, agreement.rays) : "");
  row.push_back(single && !set.any_hit ? rate_of(agreement.ties, agreement.rays) : "");
  row.push_back(timing.rays < set.rays ? format_count(timing.rays) : "all");
  return row;
}

TextTable ray_table(const SceneBench& scene, const RaySetReport& set, const std::string& baseline) {
  std::string share;
  for (const Timing& timing : set.timings) {
    if (timing.rays < set.rays) continue;  // one that shot all knows
    share = fmt::format(", {:.1f}% of them hit", 1e-4 * per_million(timing.hits, timing.rays));
    break;
  }
  TextTable table{
      fmt::format("{}: {}, {} rays{}", set.name, set.any_hit ? "any hit" : "closest hit",
                  format_count(set.rays), share),
      {"structure", "API", "M rays/s", "interval", "ratio to\n" + baseline, "interval",
       "nodes/\nray", "tests/\nray", "mismatch/\nM", "ties/\nM", "rays\nshot"},
      {}};
  table.rows.reserve(set.timings.size());
  for (std::size_t i = 0; i < scene.report.structures.size(); ++i) {
    for (const RayApi api : {RayApi::single, RayApi::batch}) {
      const Timing* timing = find_timing(set, i, api);
      if (timing != nullptr) table.rows.push_back(timing_row(scene, set, *timing));
    }
  }
  return table;
}

}  // namespace

const Timing* find_timing(const RaySetReport& set, std::size_t structure, RayApi api) {
  const auto found = std::find_if(
      set.timings.begin(), set.timings.end(),
      [&](const Timing& timing) { return timing.structure == structure && timing.api == api; });
  return found == set.timings.end() ? nullptr : &*found;
}

double per_million(std::size_t count, std::size_t of) {
  return of == 0 ? 0.0 : 1e6 * static_cast<double>(count) / static_cast<double>(of);
}

std::string short_name(const std::string& structure) {
  return std::filesystem::path(structure).filename().string();
}

std::string bench_command(const BenchOptions& options) {
  std::string command = "lume bench";
  for (const std::string& argument : options.arguments) {
    command += " " + shell_quote(printable(argument));
  }
  return command;
}

std::string describe_scene(const SceneBench& scene) {
  std::string text = fmt::format("{}: {} triangles and {} shapes, {} instances",
                                 printable(std::filesystem::path(scene.file).filename().string()),
                                 format_count(scene.triangles), format_count(scene.shapes),
                                 format_count(scene.instances));
  if (!scene.camera.empty()) {
    text += fmt::format("; {}, {}x{} pixels", printable(scene.camera), scene.size.width,
                        scene.size.height);
  }
  return text;
}

std::string describe_method(const BenchDocument& document) {
  const BenchOptions& options = document.options;
  return fmt::format(
      "{} round{} on {} thread{}, one more discarded; medians, and the intervals in which they lie "
      "with {:.1f}% confidence. Ratios are to {}'s single rays in the same round. SAH cost: 1 a "
      "node, 1 a primitive. Leaks: misses of rays at edges and corners from inside closed meshes. "
      "/M: of a million; - : not told.",
      options.repeat, options.repeat == 1 ? "" : "s", options.threads,
      options.threads == 1 ? "" : "s", 100.0 * renderer::confidence_of(options.repeat),
      printable(options.accelerators.front()));
}

std::vector<TextTable> bench_tables(const SceneBench& scene, const BenchOptions& options) {
  std::vector<TextTable> tables = {structure_table(scene)};
  tables.reserve(scene.report.sets.size() + 1);
  for (const RaySetReport& set : scene.report.sets) {
    tables.push_back(ray_table(scene, set, printable(options.accelerators.front())));
  }
  return tables;
}

std::string bench_to_text(const BenchDocument& document) {
  std::string text = describe(document.machine) + "\n" + describe_method(document) + "\n";
  for (const SceneBench& scene : document.scenes) {
    text += fmt::format("\n{}\nanswers compared with {}\n", describe_scene(scene),
                        printable(scene.reference));
    for (const TextTable& table : bench_tables(scene, document.options)) {
      text += "\n" + draw_table(table);
    }
  }
  return text;
}

}  // namespace lume::cli
