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

/// A direction on the hemisphere around +z with density (n + 1) / (2 pi) cos^n(theta) per steradian
/// (Phong's lobe; Lafortune and Willems 1994, "Using the Modified Phong Reflectance Model for
/// Physically Based Rendering", section 3). An infinite n gives +z itself.
[[nodiscard]] inline geometry::Vec3 sample_cosine_power(geometry::Vec2 random, float n) {
  // cos(theta) = (1 - random)^(1 / (n + 1)) by its logarithm: for a large n the cosine is so near 1
  // that 1 - cosine^2 would say little about the sine.
  const float log_cosine = std::log1p(-random.x) / (n + 1.0f);
  const float sine = std::sqrt(-std::expm1(2.0f * log_cosine));
  const float phi = 2.0f * geometry::k_pi * random.y;
  return {sine * std::cos(phi), sine * std::sin(phi), std::exp(log_cosine)};
}

}  // namespace lume::shading
