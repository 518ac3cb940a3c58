// SPDX-License-Identifier: Apache-2.0
// From the unit square to directions.
#pragma once

#include "geometry/math.h"

#include <algorithm>
#include <cmath>

namespace lume::shading {

/// A direction on the hemisphere around +z with density cos(theta) / pi per steradian: a uniform
/// point of the unit disk, lifted (Malley's method; Pharr, Jakob, Humphreys 2016, section 13.6.3).
[[nodiscard]] inline geometry::Vec3 sample_cosine_hemisphere(geometry::Vec2 random) {
  const float radius = std::sqrt(random.x);
  const float phi = 2.0f * geometry::k_pi * random.y;
  return {radius * std::cos(phi), radius * std::sin(phi),
          std::sqrt(std::max(0.0f, 1.0f - random.x))};
}

}  // namespace lume::shading
