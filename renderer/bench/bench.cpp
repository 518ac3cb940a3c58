// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/bench.h"

#include "shading/alpha_mask.h"

#include <algorithm>
#include <utility>

namespace lume::renderer {
namespace {

using geometry::Accelerator;

constexpr std::size_t k_counted_rays = std::size_t{1} << 16;

/// Tells how far the work is, of which building is taken for a tenth.
class Steps {
 public:
  Steps(const BenchSettings& settings, std::size_t builds, std::size_t measurements)
      : settings_(settings),
        builds_(builds),
        measurements_(std::max<std::size_t>(1, measurements)) {}

  void structure_done() { tell(built_ += 1.0 / static_cast<double>(builds_)); }
  void measured() { tell(measured_ += 1.0 / static_cast<double>(measurements_)); }

 private:
  void tell(double /*changed*/) const {
    if (settings_.on_progress) settings_.on_progress(0.1 * built_ + 0.9 * measured_);
  }

  const BenchSettings& settings_;
  std::size_t builds_;
  std::size_t measurements_;
  double built_ = 0.0;
  double measured_ = 0.0;
};

std::size_t all_measurements(std::size_t structures, std::span<const RaySet> sets,
                             const MeasureSettings& settings) {
  std::size_t count = 0;
  for (const RaySet& set : sets) count += measurement_count(structures, set, settings);
  return count;
}

}  // namespace

BenchReport run_bench(const PreparedScene& reference, std::span<const Candidate> candidates,
                      std::span<const RaySet> sets, const BenchSettings& settings) {
  const shading::Scene& scene = reference.scene();
  const shading::AlphaMask holes(scene);
  Steps steps(settings, candidates.size(),
              all_measurements(candidates.size(), sets, settings.measure));
  const std::vector<geometry::Ray> rays_inside =
      leak_rays(reference, settings.leak_rays, settings.measure.seed);

  BenchReport report;
  std::vector<std::unique_ptr<Accelerator>> owned;
  std::vector<const Accelerator*> structures;
  owned.reserve(candidates.size());
  structures.reserve(candidates.size());
  report.structures.reserve(candidates.size());
  for (const Candidate& candidate : candidates) {
    Build build = measure_build(candidate.make, scene.world, &holes);
    report.build_threads = build.threads;
    report.structures.push_back(
        {candidate.name, build.one_thread_seconds, build.all_threads_seconds, build.builds,
         build.accelerator->stats(),
         count_leaks(*build.accelerator, rays_inside, settings.agreement.budget_seconds)});
    structures.push_back(owned.emplace_back(std::move(build.accelerator)).get());
    steps.structure_done();
  }

  MeasureSettings measure = settings.measure;
  measure.on_measured = [&] { steps.measured(); };
  report.sets.reserve(sets.size());
  for (const RaySet& set : sets) {
    RaySetReport& of_set = report.sets.emplace_back();
    of_set.name = set.name;
    of_set.any_hit = set.any_hit;
    of_set.rays = set.rays.size();
    of_set.timings = measure_rays(structures, set, measure);
    of_set.agreement = compare_structures(scene.world, &holes, reference.accelerator(), structures,
                                          set, settings.agreement);
    of_set.costs.reserve(structures.size());
    for (std::size_t i = 0; i < structures.size(); ++i) {
      of_set.costs.push_back(
          mean_cost(*structures[i], set, std::min(k_counted_rays, of_set.agreement[i].rays)));
    }
  }
  return report;
}

}  // namespace lume::renderer
