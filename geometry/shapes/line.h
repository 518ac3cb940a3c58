// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/crossing.h"

#include <cmath>
#include <optional>

namespace lume::geometry {

/// The ray's point at t, rounded once: whatever the error of t, it lies on the line. From an origin
/// far away ray.at() would be off by the roundings of two large numbers that cancel.
[[nodiscard]] inline DVec3 exact_at(const ObjectRay& ray, double t) {
  const DVec3& o = ray.origin;
  const DVec3& d = ray.direction;
  return {std::fma(t, d.x, o.x), std::fma(t, d.y, o.y), std::fma(t, d.z, o.z)};
}

/// Where a ray's line is measured from: the ray's t there, and the point. From an origin far away
/// the squares of a surface's equations would cost it their last digits.
struct LineStart {
  double t = 0.0;
  DVec3 origin{0.0};
};

/// The line's point nearest to `middle`. Nothing if the line never comes within `radius` of it, or
/// is none (a zero direction, or numbers that are not finite).
[[nodiscard]] inline std::optional<LineStart> start_within(const ObjectRay& ray,
                                                           const DVec3& middle, double radius) {
  const DVec3& d = ray.direction;
  const double t = dot(middle - ray.origin, d) / dot(d, d);
  const LineStart start{t, exact_at(ray, t)};
  const DVec3 away = start.origin - middle;
  if (!(dot(away, away) <= radius * radius)) return std::nullopt;
  return start;
}

/// The ray's own origin where that is near enough to a surface of about `size` around `middle`, at
/// most a hundred sizes away; else the line's nearest point.
[[nodiscard]] inline LineStart start_near(const ObjectRay& ray, const DVec3& middle, double size) {
  const DVec3 way = middle - ray.origin;
  if (!(dot(way, way) > 1e4 * size * size)) return {0.0, ray.origin};
  const double t = dot(way, ray.direction) / dot(ray.direction, ray.direction);
  return {t, exact_at(ray, t)};
}

}  // namespace lume::geometry
