// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/torus.h"

#include "geometry/shapes/line.h"
#include "geometry/shapes/polynomial.h"
#include "geometry/shapes/round.h"
#include "geometry/shapes/span.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {
namespace {

constexpr double k_slack = 1e-14;  ///< what rounding moves a line, in units of the whole torus

/// The torus' function along the line o + s d, d a unit vector, by powers of s:
/// (s^2 + 2 b s + o.o + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), where b = o.d. The constant is written as
/// a product, ((q - R)^2 + y^2 - r^2) ((q + R)^2 + y^2 - r^2), q being the distance from the axis:
/// for a thin tube the difference of squares would cancel.
std::array<double, 5> quartic(const DVec3& o, const DVec3& d, double major, double minor) {
  const double b = dot(o, d);
  const double c = dot(o, o) + (major - minor) * (major + minor);
  const double r4 = 4.0 * major * major;
  const double q = distance_from_axis(o);
  const double rest = (o.y - minor) * (o.y + minor);
  return {((q - major) * (q - major) + rest) * ((q + major) * (q + major) + rest),
          4.0 * b * c - 2.0 * r4 * (o.x * d.x + o.z * d.z),
          4.0 * b * b + 2.0 * c - r4 * (d.x * d.x + d.z * d.z), 4.0 * b, 1.0};
}

}  // namespace

double Torus::support(const DVec3& direction) const {
  return major_radius * distance_from_axis(direction) + minor_radius * length(direction);
}

std::optional<Crossing> Torus::intersect(const ObjectRay& ray) const {
  const double size = major_radius + minor_radius;
  const auto start = start_within(ray, DVec3(0.0), (1.0 + k_slack) * size);
  if (!start) return std::nullopt;

  // In units of the whole torus.
  const double unit = size / length(ray.direction);
  const DVec3 o = start->origin / size;
  const DVec3 d = normalize(ray.direction);
  const double major = major_radius / size;
  const double minor = minor_radius / size;

  const double half = std::sqrt(std::max(0.0, 1.0 - dot(o, o))) + std::sqrt(k_slack);
  const Span in_ball{-half, half};
  const Span in_ray{(ray.t_min - start->t) / unit, (ray.t_max - start->t) / unit};
  const Span in_slab = slab(o, d, 1, -minor - k_slack, minor + k_slack, 0);
  const Span span = intersection(intersection(in_ball, in_ray), in_slab);
  if (span.is_empty()) return std::nullopt;

  for (const double s : quartic_roots(quartic(o, d, major, minor), span.enter, span.leave)) {
    const double t = start->t + s * unit;
    if (ray.contains(t)) return Crossing{.t = t};
  }
  return std::nullopt;
}

ShapePoint Torus::point(const DVec3& near, const Crossing& /*crossing*/) const {
  const DVec3 out = outwards(near);
  const DVec3 up(0.0, 1.0, 0.0);
  const double aside = distance_from_axis(near) - major_radius;
  const double from_middle = std::hypot(aside, near.y);
  const double sine = from_middle > 0.0 ? aside / from_middle : 1.0;  // of the angle from the top
  const double cosine = from_middle > 0.0 ? near.y / from_middle : 0.0;
  const double ring = major_radius + minor_radius * sine;
  const double angle = std::atan2(sine, cosine);

  ShapePoint point;
  point.normal = sine * out + cosine * up;
  point.position = ring * out + minor_radius * cosine * up;
  point.uv = {turn_of(near), angle < 0.0 ? 1.0 + angle / k_turn : angle / k_turn};
  point.dp_du = k_turn * ring * eastwards(near);
  point.dp_dv = k_turn * minor_radius * (cosine * out - sine * up);
  return point;
}

}  // namespace lume::geometry
