// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/bench_report.h"

#include <nlohmann/json.hpp>

namespace lume::cli {
namespace {

using Json = nlohmann::ordered_json;
using renderer::Estimate;

Json to_json(const Estimate& estimate) {
  return {{"median", estimate.median}, {"low", estimate.low}, {"high", estimate.high}};
}

Json to_json(const Machine& machine) {
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"instruction_set", machine.instruction_set},
          {"compiler", machine.compiler},
          {"compiled_for", machine.compiled_for},
          {"embree", machine.embree}};
}

Json to_json(const renderer::StructureReport& structure) {
  const geometry::StructureStats& stats = structure.stats.structure;
  return {{"name", structure.name},
          {"build_seconds_one_thread", structure.one_thread_seconds},
          {"build_seconds_all_threads", structure.all_threads_seconds},
          {"builds", structure.builds},
          {"primitives", structure.stats.primitives},
          {"memory_bytes", structure.stats.memory_bytes},
          {"nodes", stats.nodes},
          {"leaves", stats.leaves},
          {"depth", stats.depth},
          {"references", stats.references},
          {"sah_cost", stats.sah_cost},
          {"leaks",
           {{"rays", structure.leaks.rays},
            {"missed_closest", structure.leaks.missed_closest},
            {"missed_any", structure.leaks.missed_any}}}};
}

Json to_json(const renderer::RaySetReport& set, const SceneBench& scene) {
  const auto name = [&](std::size_t i) { return scene.report.structures[i].name; };
  Json json = {{"name", set.name},           {"query", set.any_hit ? "any" : "closest"},
               {"rays", set.rays},           {"timings", Json::array()},
               {"agreement", Json::array()}, {"costs", Json::array()}};
  for (const renderer::Timing& timing : set.timings) {
    json["timings"].push_back({{"structure", name(timing.structure)},
                               {"api", timing.api == renderer::RayApi::single ? "single" : "batch"},
                               {"rays", timing.rays},
                               {"hits", timing.hits},
                               {"rays_per_second", to_json(timing.rate)},
                               {"ratio", to_json(timing.ratio)}});
  }
  for (std::size_t i = 0; i < set.agreement.size(); ++i) {
    json["agreement"].push_back({{"structure", name(i)},
                                 {"rays", set.agreement[i].rays},
                                 {"mismatches", set.agreement[i].mismatches},
                                 {"ties", set.agreement[i].ties}});
  }
  for (std::size_t i = 0; i < set.costs.size(); ++i) {
    if (!set.costs[i]) continue;
    json["costs"].push_back({{"structure", name(i)},
                             {"rays", set.costs[i]->rays},
                             {"nodes", set.costs[i]->nodes},
                             {"primitive_tests", set.costs[i]->primitive_tests}});
  }
  return json;
}

Json to_json(const SceneBench& scene) {
  Json json = {{"file", scene.file},
               {"camera", scene.camera},
               {"triangles", scene.triangles},
               {"shapes", scene.shapes},
               {"instances", scene.instances},
               {"reference", scene.reference},
               {"build_threads", scene.report.build_threads},
               {"structures", Json::array()},
               {"ray_sets", Json::array()}};
  for (const auto& structure : scene.report.structures) {
    json["structures"].push_back(to_json(structure));
  }
  for (const auto& set : scene.report.sets) json["ray_sets"].push_back(to_json(set, scene));
  return json;
}

}  // namespace

std::string bench_to_json(const BenchDocument& document) {
  const BenchOptions& options = document.options;
  Json json = {{"lume", document.machine.lume},
               {"command", bench_command(options)},
               {"machine", to_json(document.machine)},
               {"baseline", options.accelerators.front()},
               {"settings",
                {{"rounds", options.repeat},
                 {"confidence", renderer::confidence_of(options.repeat)},
                 {"threads", options.threads},
                 {"budget_seconds", options.budget},
                 {"count", options.count},
                 {"seed", options.seed}}},
               {"scenes", Json::array()}};
  if (options.hit_rate) json["settings"]["hit_rate_percent"] = *options.hit_rate;
  for (const SceneBench& scene : document.scenes) json["scenes"].push_back(to_json(scene));
  // A file's name need not be UTF-8, JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lume::cli
