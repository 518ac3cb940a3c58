// SPDX-License-Identifier: Apache-2.0
// Ray sets of a given hit rate: a structure that is quick to say "nothing" and one that is quick to
// say "this one" can only be told apart when the share of either is known.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "renderer/bench/ray_sets.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lume::renderer {

struct HitCounts {
  std::size_t hits = 0;
  std::size_t misses = 0;

  [[nodiscard]] std::size_t total() const { return hits + misses; }
};

/// The most rays of which `share` (0 to 1) hit, out of so many; nothing if there are none.
[[nodiscard]] std::optional<HitCounts> counts_for_hit_rate(const HitCounts& recorded, double share);

/// Leaves out rays, evenly along the set and as few as possible, until `share` of them hit
/// something. Returns how many did before; the set is empty if none can be chosen.
HitCounts keep_hit_rate(RaySet& set, const geometry::Accelerator& accelerator, double share);

}  // namespace lume::renderer
