// SPDX-License-Identifier: Apache-2.0
// Rays that cannot get out, and those that do: the test of a watertight traversal. A ray at the
// edge between two triangles belongs to one of them, and one from inside a closed mesh meets
// something whichever way it goes.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "renderer/prepared_scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lume::renderer {

/// Rays from inside the scene's closed meshes (without holes) towards points of their edges and
/// corners, up to `count`; none if the scene has no such meshes. `prepared` finds the places
/// inside.
[[nodiscard]] std::vector<geometry::Ray> leak_rays(const PreparedScene& prepared, std::size_t count,
                                                   std::uint64_t seed);

struct Leaks {
  std::size_t rays = 0;
  std::size_t missed_closest = 0;  ///< rays for which closest_hit found nothing
  std::size_t missed_any = 0;      ///< rays for which any_hit found nothing
};

/// Stops when the time is over.
[[nodiscard]] Leaks count_leaks(const geometry::Accelerator& accelerator,
                                const std::vector<geometry::Ray>& rays, double budget_seconds);

}  // namespace lume::renderer
