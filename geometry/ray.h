// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

#include <cmath>
#include <limits>

namespace lume::geometry {

/// The half-open line origin + t * direction, t_min <= t <= t_max, in the scene's frame (metres).
/// The direction need not be a unit vector; t counts in its lengths.
struct Ray {
  Vec3 origin{0.0f};
  float t_min = 0.0f;
  Vec3 direction{0.0f, 0.0f, -1.0f};
  float t_max = std::numeric_limits<float>::infinity();
};

/// True if every accelerator may trace the ray. Some (Embree with asserts) abort on a ray that is
/// not finite, so each query asks this first and treats other rays as meeting nothing.
[[nodiscard]] inline bool is_traceable(const Ray& ray) {
  const auto is_near = [](const Vec3& v) {
    constexpr float k_farthest = 1e18f;  // Embree rejects origins at 2e18 and beyond
    return std::abs(v.x) < k_farthest && std::abs(v.y) < k_farthest && std::abs(v.z) < k_farthest;
  };
  return is_near(ray.origin) && is_near(ray.direction) && ray.t_min >= 0.0f &&
         ray.t_max >= ray.t_min;
}

}  // namespace lume::geometry
