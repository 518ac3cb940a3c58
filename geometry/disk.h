// SPDX-License-Identifier: Apache-2.0
// From the unit square to the unit disk.
#pragma once

#include "geometry/math.h"

#include <cmath>

namespace lume::geometry {

/// Uniform over the unit disk for two numbers in [0, 1); (0.5, 0.5) is the centre. Squares around
/// the square's centre become circles around the disk's, so that neighbours stay neighbours and
/// well spread numbers give well spread points (Shirley and Chiu 1997, "A Low Distortion Map
/// Between Disk and Square").
[[nodiscard]] inline Vec2 concentric_disk(Vec2 random) {
  const Vec2 p = 2.0f * random - 1.0f;
  if (p.x == 0.0f && p.y == 0.0f) return p;
  const bool flat = std::abs(p.x) > std::abs(p.y);  // the sectors around the axis x
  const float radius = flat ? p.x : p.y;
  const float angle = 0.25f * k_pi * (flat ? p.y / p.x : 2.0f - p.x / p.y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace lume::geometry
