// SPDX-License-Identifier: Apache-2.0
// A race of structures over the same rays. Machines change their speed while they are measured, by
// more than structures differ. So all take turns on one ray set, in another order each round, and
// are compared within a round; what is reported is the median of those ratios.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "renderer/bench/ray_sets.h"
#include "renderer/bench/shoot.h"
#include "renderer/bench/statistics.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lume::renderer {

struct MeasureSettings {
  std::size_t rounds = 9;  ///< that count; one more is discarded
  unsigned threads = 1;
  /// What one measurement may take (seconds); a structure that needs longer for a whole set shoots
  /// a part of it, spread evenly.
  double budget_seconds = 0.25;
  std::uint64_t seed = 0;  ///< of the order in a round
  std::function<void()> on_measured;
};

/// One structure, one ray set, one way of shooting.
struct Timing {
  std::size_t structure = 0;  ///< index into the contenders
  RayApi api = RayApi::single;
  std::size_t rays = 0;  ///< shot in each round
  std::size_t hits = 0;  ///< of them
  Estimate rate;         ///< rays a second
  /// The rate over that of the first structure's single rays in the same round.
  Estimate ratio;
};

/// How many times measure_rays calls on_measured.
[[nodiscard]] std::size_t measurement_count(std::size_t structures, const RaySet& set,
                                            const MeasureSettings& settings);

/// All contenders, single rays first; then, of a coherent set, all in batches. An empty set gives
/// nothing.
[[nodiscard]] std::vector<Timing> measure_rays(
    std::span<const geometry::Accelerator* const> contenders, const RaySet& set,
    const MeasureSettings& settings);

/// `count` of the rays, in runs of k_batch_size that are spread evenly over all.
[[nodiscard]] std::vector<geometry::Ray> spread_rays(std::span<const geometry::Ray> rays,
                                                     std::size_t count);

}  // namespace lume::renderer
