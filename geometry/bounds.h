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
  /// False for the bounds of nothing, and of what has no end.
  [[nodiscard]] bool is_finite() const {
    return geometry::is_finite(lower) && geometry::is_finite(upper);
  }
  [[nodiscard]] Vec3 center() const { return 0.5f * lower + 0.5f * upper; }
  [[nodiscard]] Vec3 size() const { return is_empty() ? Vec3(0.0f) : upper - lower; }
  /// Half the diagonal: the radius of the sphere around the box (metres).
  [[nodiscard]] float radius() const { return 0.5f * length(size()); }
};

/// The same in double, for what is not yet placed near the origin.
struct DBounds {
  DVec3 lower{std::numeric_limits<double>::infinity()};
  DVec3 upper{-std::numeric_limits<double>::infinity()};

  void add(const DVec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  [[nodiscard]] bool is_empty() const { return lower.x > upper.x; }
  [[nodiscard]] DVec3 size() const { return upper - lower; }
};

}  // namespace lume::geometry
