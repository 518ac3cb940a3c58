// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_report.h"

#include <fmt/format.h>

namespace lume::cli {
namespace {

constexpr const char* k_header =
    "scene,structure,rays,query,api,rays_shot,hits,rays_per_second,rays_per_second_low,"
    "rays_per_second_high,ratio,ratio_low,ratio_high,nodes_per_ray,tests_per_ray,rays_compared,"
    "mismatches,ties,build_seconds_one_thread,build_seconds_all_threads,memory_bytes\r\n";

/// A field in quotes where it needs them.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string line(const SceneBench& scene, const renderer::RaySetReport& set,
                 const renderer::Timing& timing) {
  const renderer::StructureReport& structure = scene.report.structures[timing.structure];
  const renderer::Agreement& agreement = set.agreement[timing.structure];
  const auto& cost = set.costs[timing.structure];
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", field(scene.file),
      field(structure.name), field(set.name), set.any_hit ? "any" : "closest",
      timing.api == renderer::RayApi::single ? "single" : "batch", timing.rays, timing.hits,
      timing.rate.median, timing.rate.low, timing.rate.high, timing.ratio.median, timing.ratio.low,
      timing.ratio.high, cost ? fmt::format("{}", cost->nodes) : "",
      cost ? fmt::format("{}", cost->primitive_tests) : "", agreement.rays, agreement.mismatches,
      agreement.ties, structure.one_thread_seconds, structure.all_threads_seconds,
      structure.stats.memory_bytes);
}

}  // namespace

std::string bench_to_csv(const BenchDocument& document) {
  std::string text = k_header;
  for (const SceneBench& scene : document.scenes) {
    for (const renderer::RaySetReport& set : scene.report.sets) {
      for (const renderer::Timing& timing : set.timings) text += line(scene, set, timing);
    }
  }
  return text;
}

}  // namespace lume::cli
