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

/// Where a ray's line is measured from: the ray's t there, and the point.
struct LineStart {
  double t = 0.0;
  DVec3 origin{0.0};
};

/// A start near enough to a surface of about `size` around `middle` for its equations: the ray's
/// own origin, or if that is more than a hundred sizes away, where its squares would cost those of
/// the surface their last digits, the line's point nearest to the middle.
[[nodiscard]] inline LineStart start_near(const ObjectRay& ray, const DVec3& middle, double size) {
  const DVec3 way = middle - ray.origin;
  if (!(dot(way, way) > 1e4 * size * size)) return {0.0, ray.origin};
  const double t = dot(way, ray.direction) / dot(ray.direction, ray.direction);
  return {t, exact_at(ray, t)};
}

/// A ray's line, restarted where it comes nearest to a surface: an origin far away would cost the
/// surface's equations their last digits.
struct NearLine {
  DVec3 origin{0.0};
  DVec3 direction{0.0};
  double shift = 0.0;  ///< the ray's t of the origin

  /// The line restarted at the point nearest to `middle`. Nothing if the line never comes within
  /// `radius` of it, or is none (a zero direction, or numbers that are not finite).
  [[nodiscard]] static std::optional<NearLine> make(const ObjectRay& ray, const DVec3& middle,
                                                    double radius) {
    const DVec3& d = ray.direction;
    const double t = dot(middle - ray.origin, d) / dot(d, d);
    const DVec3 nearest = exact_at(ray, t);
    const DVec3 away = nearest - middle;
    if (!(dot(away, away) <= radius * radius)) return std::nullopt;
    return NearLine{nearest, d, t};
  }
};

}  // namespace lume::geometry
