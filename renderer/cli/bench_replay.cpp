// SPDX-License-Identifier: Apache-2.0
// `lume bench --replay`: single rays, for a debugger.
#include "io/ray_file.h"
#include "renderer/cli/bench_modes.h"
#include "renderer/cli/result_output.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace lume::cli {
namespace {

/// What a structure said of a ray.
struct Answer {
  std::optional<geometry::Hit> hit;
  bool occluded = false;

  bool operator==(const Answer&) const = default;
};

std::string describe(const io::RayList& list, std::size_t i) {
  return fmt::format("ray {} of {} ({})\n{}", i, printable(list.name),
                     list.any_hit ? "any hit" : "closest hit", describe_ray(list.rays[i]));
}

}  // namespace

ExitCode run_replay(const BenchOptions& options) {
  const BenchOptions of_scene = options_for(options, options.scene_files.front(), 1280);
  const std::vector<io::RayList> lists = io::read_rays(*options.replay);
  const io::LoadedScene loaded = load_scene(of_scene);
  const Viewpoint view = choose_viewpoint(loaded.scene, of_scene);
  std::vector<std::unique_ptr<renderer::PreparedScene>> structures;
  structures.reserve(options.accelerators.size());
  std::size_t width = 0;
  for (const renderer::Candidate& candidate : name_candidates(options.accelerators, view, {})) {
    structures.push_back(std::make_unique<renderer::PreparedScene>(loaded.scene, candidate.make));
    width = std::max(width, candidate.name.size());
  }
  bool agree = true;
  for (const io::RayList& list : lists) {
    for (std::size_t i = 0; i < list.rays.size(); ++i) {
      std::string text = describe(list, i);
      std::optional<Answer> first;
      for (std::size_t k = 0; k < structures.size(); ++k) {
        const geometry::Accelerator& accelerator = structures[k]->accelerator();
        const Answer answer{accelerator.closest_hit(list.rays[i]),
                            accelerator.any_hit(list.rays[i])};
        if (!first) first = answer;
        const bool same = answer == *first;
        agree = agree && same;
        text += fmt::format("  {:<{}}  closest hit: {}; any hit: {}{}\n",
                            printable(options.accelerators[k]), width,
                            describe_hit(answer.hit, list.rays[i], *structures[k]),
                            answer.occluded ? "yes" : "no", same ? "" : "  <- differs");
      }
      print_result(text);
    }
  }
  return agree ? ExitCode::success : ExitCode::disagreement;
}

}  // namespace lume::cli
