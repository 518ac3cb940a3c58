// SPDX-License-Identifier: Apache-2.0
// The sphere x.x = r^2: with x = o + t d a quadratic a t^2 + 2 b t + c = 0, whose discriminant says
// whether it is met.
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/round.h"
#include "geometry/shapes/shape_point.h"

#include <cmath>
#include <optional>

namespace lume::geometry {

struct Sphere {
  double radius = 0.5;  ///< metres

  /// The largest dot(p, direction) over all points p.
  [[nodiscard]] double support(const DVec3& direction) const { return radius * length(direction); }

  /// Of the two forms of a root the one whose sum does not cancel: c / q for the other. The
  /// discriminant b^2 - a c would cancel for an origin far away; by Lagrange's identity it is
  /// a r^2 - |o x d|^2, in which only the line's distance from the centre counts (cf. Haines et al.
  /// 2019, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7).
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const {
    const DVec3& o = ray.origin;
    const DVec3& d = ray.direction;
    const double a = dot(d, d);
    const DVec3 moment = cross(o, d);
    const double discriminant = a * radius * radius - dot(moment, moment);
    if (!(discriminant >= 0.0 && a > 0.0)) return std::nullopt;  // a miss, or not a number
    const double b = -dot(o, d);
    const double c = dot(o, o) - radius * radius;
    const double root = std::sqrt(discriminant);
    const double q = b < 0.0 ? b - root : b + root;
    const double first = b < 0.0 ? q / a : c / q;
    if (ray.contains(first)) return Crossing{.t = first};
    const double second = b < 0.0 ? c / q : q / a;
    if (ray.contains(second)) return Crossing{.t = second};
    return std::nullopt;
  }

  /// u once around the axis y, v from the north pole to the south pole.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& /*crossing*/) const {
    const DVec3 n = normalize(near);
    const double ring = distance_from_axis(n);  // the sine of the angle from the pole
    const DVec3 east = eastwards(n);
    ShapePoint point;
    point.position = radius * n;
    point.normal = n;
    point.uv = {turn_of(n), 2.0 * std::atan2(ring, n.y) / k_turn};
    point.dp_du = k_turn * radius * ring * east;
    point.dp_dv = 0.5 * k_turn * radius * cross(east, n);
    return point;
  }
};

}  // namespace lume::geometry
