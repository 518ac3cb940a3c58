// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

#include <limits>

namespace lume::geometry {

/// An axis-aligned box. The default one is empty: it contains no point and adds nothing.
struct Bounds {
  Vec3 lower{std::numeric_limits<float>::infinity()};
  Vec3 upper{-std::numeric_limits<float>::infinity()};

  void add(const Vec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  void add(const Bounds& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  [[nodiscard]] bool is_empty() const { return lower.x > upper.x; }
  [[nodiscard]] Vec3 center() const { return 0.5f * lower + 0.5f * upper; }
  [[nodiscard]] Vec3 size() const { return is_empty() ? Vec3(0.0f) : upper - lower; }
  /// Half the diagonal: the radius of the sphere around the box (metres).
  [[nodiscard]] float radius() const { return 0.5f * length(size()); }
};

}  // namespace lume::geometry
