// SPDX-License-Identifier: Apache-2.0
// Rays through a structure, against the clock.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "renderer/bench/ray_sets.h"

#include <cstddef>
#include <span>

namespace lume::renderer {

/// By which of a structure's functions rays are shot.
enum class RayApi {
  single,  ///< closest_hit or any_hit, ray by ray
  batch    ///< closest_hits or any_hits, k_batch_size rays at a time
};

/// Shoots the rays one after the other; returns how many hit something.
[[nodiscard]] std::size_t shoot(const geometry::Accelerator& accelerator,
                                std::span<const geometry::Ray> rays, bool any_hit, RayApi api);

struct Shot {
  /// On one thread: of the processor, which no other program can stretch. On several: of the clock,
  /// from the common start until the last one is done.
  double seconds = 0.0;
  std::size_t hits = 0;
};

/// The same on so many threads, each with its own stretch of the rays.
[[nodiscard]] Shot shoot_timed(const geometry::Accelerator& accelerator,
                               std::span<const geometry::Ray> rays, bool any_hit, RayApi api,
                               unsigned threads);

}  // namespace lume::renderer
