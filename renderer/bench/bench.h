// SPDX-License-Identifier: Apache-2.0
// Structures compared over one scene: what they take to build, what they are made of, how fast they
// answer, what they look at, and whether they agree.
#pragma once

#include "renderer/bench/agreement.h"
#include "renderer/bench/build_time.h"
#include "renderer/bench/cost.h"
#include "renderer/bench/leaks.h"
#include "renderer/bench/measure.h"
#include "renderer/bench/ray_sets.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lume::renderer {

/// A structure that takes part.
struct Candidate {
  std::string name;
  AcceleratorFactory make;
};

struct BenchSettings {
  MeasureSettings measure;
  AgreementSettings agreement;
  std::size_t leak_rays = std::size_t{1} << 16;
  /// Between 0 and 1, after each step.
  std::function<void(double)> on_progress;
};

/// A structure by itself.
struct StructureReport {
  std::string name;
  double one_thread_seconds = 0.0;
  double all_threads_seconds = 0.0;
  int builds = 1;
  geometry::AcceleratorStats stats;
  Leaks leaks;
};

/// One ray set, and how every structure did on it.
struct RaySetReport {
  std::string name;
  bool any_hit = false;
  std::size_t rays = 0;
  std::vector<Timing> timings;
  std::vector<Agreement> agreement;            ///< by structure
  std::vector<std::optional<MeanCost>> costs;  ///< by structure
};

struct BenchReport {
  unsigned build_threads = 1;  ///< of StructureReport::all_threads_seconds
  std::vector<StructureReport> structures;
  std::vector<RaySetReport> sets;
};

/// The first candidate is what the others are compared with in speed; `reference`, built by exact
/// rules, in its answers. No ThreadLimit may be alive.
[[nodiscard]] BenchReport run_bench(const PreparedScene& reference,
                                    std::span<const Candidate> candidates,
                                    std::span<const RaySet> sets, const BenchSettings& settings);

}  // namespace lume::renderer
