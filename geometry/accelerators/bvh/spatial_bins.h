// SPDX-License-Identifier: Apache-2.0
// Where to cut space, and what comes to which side: the planes that a spatial split is chosen from.
#pragma once

#include "geometry/accelerators/bvh/top_down.h"

#include <limits>
#include <utility>

namespace lume::geometry::bvh {

/// A plane that parts space, and what is cut by it.
struct SpatialSplit {
  double cost = std::numeric_limits<double>::infinity();  ///< as BinSplit::cost
  int axis = 0;
  float plane = 0.0f;
  Bounds left, right;  ///< around what comes to each side
  std::size_t left_count = 0;
  std::size_t right_count = 0;
};

/// The cheapest one that makes at most `spare` entries more.
[[nodiscard]] SpatialSplit find_spatial_split(const Items& items, std::span<const Entry> entries,
                                              std::size_t spare);

/// The entries of both sides. One that the plane cuts comes to both, each with what is left of its
/// box there, or as a whole to one, if that is cheaper (section 4.4, "reference unsplitting").
[[nodiscard]] std::pair<std::vector<Entry>, std::vector<Entry>> cut_entries(
    const Items& items, std::span<const Entry> entries, const SpatialSplit& split);

}  // namespace lume::geometry::bvh
