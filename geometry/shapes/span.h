// SPDX-License-Identifier: Apache-2.0
// A solid as a ray sees it: the stretch of the line that is inside. Solids are cut and joined by
// comparing the ends of such stretches, so no ray slips through the rim where two surfaces of one
// solid meet.
#pragma once

#include "geometry/bounds.h"
#include "geometry/crossing.h"

#include <cmath>
#include <limits>
#include <optional>

namespace lume::geometry {

/// The stretch enter <= t <= leave of a line, and the parts of the solid that it is cut off by.
struct Span {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  std::uint32_t enter_part = 0;
  std::uint32_t leave_part = 0;

  [[nodiscard]] bool is_empty() const { return !(enter <= leave); }  // also if one is not a number
};

/// Empty, whatever it is cut with.
inline constexpr Span k_no_span{std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};

/// What two solids have in common.
[[nodiscard]] inline Span intersection(const Span& a, const Span& b) {
  Span result = a;
  if (b.enter > a.enter) {
    result.enter = b.enter;
    result.enter_part = b.enter_part;
  }
  if (b.leave < a.leave) {
    result.leave = b.leave;
    result.leave_part = b.leave_part;
  }
  return result;
}

/// From where the first of two overlapping solids begins to where the last one ends.
[[nodiscard]] inline Span hull(const Span& a, const Span& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  Span result = a;
  if (b.enter < a.enter) {
    result.enter = b.enter;
    result.enter_part = b.enter_part;
  }
  if (b.leave > a.leave) {
    result.leave = b.leave;
    result.leave_part = b.leave_part;
  }
  return result;
}

/// The stretch with `t` added to both ends.
[[nodiscard]] inline Span shifted(Span span, double t) {
  span.enter += t;
  span.leave += t;
  return span;
}

/// The first end of the stretch that lies on the ray.
[[nodiscard]] inline std::optional<Crossing> first_end(const Span& span, const ObjectRay& ray) {
  if (span.is_empty()) return std::nullopt;
  if (std::isfinite(span.enter) && ray.contains(span.enter)) {
    return Crossing{.t = span.enter, .part = span.enter_part};
  }
  if (std::isfinite(span.leave) && ray.contains(span.leave)) {
    return Crossing{.t = span.leave, .part = span.leave_part};
  }
  return std::nullopt;
}

/// The stretch between the planes x[axis] = lower and upper (Kay and Kajiya 1986, "Ray Tracing
/// Complex Scenes": slabs). Its ends are of the parts `lower_part` and `lower_part + 1`.
[[nodiscard]] inline Span slab(const DVec3& origin, const DVec3& direction, int axis, double lower,
                               double upper, std::uint32_t lower_part) {
  if (direction[axis] == 0.0) {
    const bool is_between = origin[axis] >= lower && origin[axis] <= upper;
    return is_between ? Span() : k_no_span;
  }
  const double t_lower = (lower - origin[axis]) / direction[axis];
  const double t_upper = (upper - origin[axis]) / direction[axis];
  if (direction[axis] > 0.0) return {t_lower, t_upper, lower_part, lower_part + 1};
  return {t_upper, t_lower, lower_part + 1, lower_part};
}

/// The stretch inside a box, for lines of which no number is NaN. Its ends are of the parts
/// `first_part` plus the face (face.h).
[[nodiscard]] inline Span box_span(const DVec3& origin, const DVec3& direction, const DBounds& box,
                                   std::uint32_t first_part) {
  const auto axis_slab = [&](int axis) {
    return slab(origin, direction, axis, box.lower[axis], box.upper[axis],
                first_part + 2 * static_cast<std::uint32_t>(axis));
  };
  return intersection(intersection(axis_slab(0), axis_slab(1)), axis_slab(2));
}

}  // namespace lume::geometry
