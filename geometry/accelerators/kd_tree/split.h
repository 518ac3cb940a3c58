// SPDX-License-Identifier: Apache-2.0
// Which plane to cut a node with: the surface area heuristic (MacDonald and Booth 1990, "Heuristics
// for Ray Tracing Using Space Subdivision").
#pragma once

#include "geometry/accelerators/kd_tree/events.h"

#include <limits>

namespace lume::geometry::kd_tree {

/// What it takes to test an item, where to go through an inner node takes 1.
inline constexpr double k_test_cost = 1.5;
/// Of the cost of a cut that makes an empty child: rays pass it for nothing, which the heuristic
/// undervalues (Wald and Havran 2006).
inline constexpr double k_empty_bonus = 0.8;

struct Split {
  /// Of a ray through the node if its children are leaves. Infinite: there is no plane.
  double cost = std::numeric_limits<double>::infinity();
  Plane plane;
  std::size_t left = 0;  ///< items on each side; what is cut counts on both
  std::size_t right = 0;
};

/// The cheapest of all planes through sides of items, inside the box, that cut no more than `spare`
/// items.
[[nodiscard]] Split find_split(const EventLists& events, const Bounds& box, std::size_t spare);

}  // namespace lume::geometry::kd_tree
