// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

#include <limits>

namespace lume::geometry {

/// An axis-aligned box. The default one is empty: it contains no point and adds nothing.
template <class Point>
struct BoundsOf {
  using Number = typename Point::value_type;

  Point lower{std::numeric_limits<Number>::infinity()};
  Point upper{-std::numeric_limits<Number>::infinity()};

  void add(const Point& point) { add(BoundsOf{point, point}); }
  void add(const BoundsOf& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  [[nodiscard]] bool is_empty() const { return lower.x > upper.x; }
  /// False for the bounds of nothing, and of what has no end.
  [[nodiscard]] bool is_finite() const {
    const Point zero(Number(0));  // its product with what is not finite is not a number
    return dot(lower, zero) + dot(upper, zero) == Number(0);
  }
  [[nodiscard]] bool contains(const Point& point) const {
    for (int i = 0; i < Point::length(); ++i) {
      if (!(point[i] >= lower[i] && point[i] <= upper[i])) return false;
    }
    return true;
  }
  [[nodiscard]] Point center() const { return Number(0.5) * lower + Number(0.5) * upper; }
  [[nodiscard]] Point size() const { return is_empty() ? Point(Number(0)) : upper - lower; }
  /// Half the diagonal: the radius of the sphere around the box (metres).
  [[nodiscard]] Number radius() const { return Number(0.5) * length(size()); }
};

using Bounds = BoundsOf<Vec3>;
/// For what is not yet placed near the origin.
using DBounds = BoundsOf<DVec3>;

}  // namespace lume::geometry
