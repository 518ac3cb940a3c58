// SPDX-License-Identifier: Apache-2.0
// The tapered cylinder around y of glTF's implicit shapes: the solid x^2 + z^2 <= r(y)^2 between
// two planes, its radius r(y) going evenly from the one at the bottom to the one at the top. A cone
// has one radius 0.
#pragma once

#include "geometry/shapes/face.h"
#include "geometry/shapes/line.h"
#include "geometry/shapes/quadratic.h"
#include "geometry/shapes/round.h"
#include "geometry/shapes/span.h"

#include <algorithm>

namespace lume::geometry {

struct Cylinder {
  enum Part : std::uint32_t { side, bottom, top };

  double height = 0.5;  ///< metres
  double radius_bottom = 0.25;
  double radius_top = 0.25;

  /// The largest dot(p, direction) over all points p.
  [[nodiscard]] double support(const DVec3& direction) const {
    const double ring = distance_from_axis(direction);
    const double rise = 0.5 * height * direction.y;
    return std::max(radius_top * ring + rise, radius_bottom * ring - rise);
  }

  /// How much the radius grows for each metre up.
  [[nodiscard]] double slope() const { return (radius_top - radius_bottom) / height; }
  [[nodiscard]] double radius_at(double y) const {
    return 0.5 * (radius_bottom + radius_top) + slope() * y;
  }

  /// The stretch of the line o + t d that is inside. The origin must not be far, or it would cancel
  /// in c.
  [[nodiscard]] Span inside(const DVec3& o, const DVec3& d) const {
    const Span between = slab(o, d, 1, -0.5 * height, 0.5 * height, bottom);
    if (between.is_empty()) return between;

    const double r = radius_at(o.y);
    const double dr = slope() * d.y;
    const double a = d.x * d.x + d.z * d.z - dr * dr;
    const double b = o.x * d.x + o.z * d.z - r * dr;
    const double c = o.x * o.x + o.z * o.z - r * r;
    const auto [first, second] = solve_quadratic(a, b, c);
    const Span all;
    if (std::isnan(first)) return c <= 0.0 && !std::isnan(b) ? between : k_no_span;
    if (a > 0.0) return intersection(between, Span{first, second});
    // The line is steeper than the cone: it is inside before one root and after the other, once in
    // the cone itself and once in the cone's mirror image beyond the apex.
    const Span before = intersection(between, Span{all.enter, first});
    const Span after = intersection(between, Span{second, all.leave});
    const bool is_before = before.leave - before.enter >= after.leave - after.enter;
    return is_before ? before : after;
  }

  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const {
    const auto [t, origin] = start_near(ray, DVec3(0.0), height + radius_bottom + radius_top);
    return first_end(shifted(inside(origin, ray.direction), t), ray);
  }

  /// On the side u once around and v from top to bottom; the ends have the image of a disk.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const {
    if (crossing.part != side) {
      const double radius = crossing.part == top ? radius_top : radius_bottom;
      const DVec3 corner(radius, 0.5 * height, radius);
      return face_point(near, crossing.part == top ? 3 : 2, -corner, corner);
    }
    const double y = std::clamp(near.y, -0.5 * height, 0.5 * height);
    const double radius = radius_at(y);
    const DVec3 out = outwards(near);
    const DVec3 up(0.0, 1.0, 0.0);
    ShapePoint point;
    point.position = radius * out + y * up;
    point.normal = out - slope() * up;
    point.uv = {turn_of(near), 0.5 - y / height};
    point.dp_du = k_turn * radius * eastwards(near);
    point.dp_dv = -height * (up + slope() * out);
    return point;
  }
};

}  // namespace lume::geometry
