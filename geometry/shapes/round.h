// SPDX-License-Identifier: Apache-2.0
// The angle around the axis y, which every round shape takes for its texture coordinate u.
#pragma once

#include "geometry/math.h"

#include <cmath>
#include <numbers>

namespace lume::geometry {

inline constexpr double k_turn = 2.0 * std::numbers::pi;

[[nodiscard]] inline double distance_from_axis(const DVec3& p) {
  return std::sqrt(p.x * p.x + p.z * p.z);
}

/// The angle of a point around y as a part of a turn, in [0, 1]: 0.5 towards +z, growing towards
/// +x, counter-clockwise as seen from above.
[[nodiscard]] inline double turn_of(const DVec3& p) { return 0.5 + std::atan2(p.x, p.z) / k_turn; }

/// The unit direction in which turn_of() grows; +x on the axis itself.
[[nodiscard]] inline DVec3 eastwards(const DVec3& p) {
  const double ring = distance_from_axis(p);
  return ring > 0.0 ? DVec3(p.z / ring, 0.0, -p.x / ring) : DVec3(1.0, 0.0, 0.0);
}

/// The unit direction away from the axis; +z on the axis itself.
[[nodiscard]] inline DVec3 outwards(const DVec3& p) {
  const double ring = distance_from_axis(p);
  return ring > 0.0 ? DVec3(p.x / ring, 0.0, p.z / ring) : DVec3(0.0, 0.0, 1.0);
}

}  // namespace lume::geometry
