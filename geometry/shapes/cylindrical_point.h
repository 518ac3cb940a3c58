// SPDX-License-Identifier: Apache-2.0
// Texture coordinates for surfaces that have none of their own, known by a point and a gradient:
// those of a cylinder around the axis y.
#pragma once

#include "geometry/math.h"
#include "geometry/shapes/round.h"
#include "geometry/shapes/shape_point.h"

#include <cmath>

namespace lume::geometry {

/// A gradient as a unit normal, whatever its length; +y where there is none (a cone's apex).
[[nodiscard]] inline DVec3 unit_normal(const DVec3& gradient) {
  const DVec3 size = abs(gradient);
  const double largest = std::fmax(size.x, std::fmax(size.y, size.z));
  const DVec3 n = normalize(gradient / largest);
  return std::isfinite(n.x + n.y + n.z) ? n : DVec3(0.0, 1.0, 0.0);
}

/// A point of a surface whose front is where the gradient points to: u once around the axis y, v
/// from the height y_upper down to y_lower, or -y in metres if these are not both finite.
///
/// With the distance r from the axis as a function of the angle and of y, as the theorem of
/// implicit functions gives it, dp_du keeps y and dp_dv keeps the angle. Where the front faces the
/// axis, u runs the other way around (it always grows to the right as seen from the front). Where
/// the surface runs along the radius, r is no such function: the two are then unit-speed directions
/// in the tangent plane.
[[nodiscard]] inline ShapePoint cylindrical_point(const DVec3& position, const DVec3& gradient,
                                                  double y_lower, double y_upper) {
  const double height = y_upper - y_lower;
  const bool has_height = std::isfinite(height) && height > 0.0;
  const double metres_per_v = has_height ? height : 1.0;
  const DVec3 n = unit_normal(gradient);
  const DVec3 east = eastwards(position);
  const DVec3 out = outwards(position);
  const double metres_per_u = k_turn * distance_from_axis(position);
  const double outward = dot(n, out);
  const bool mirrored = outward < 0.0;

  ShapePoint point;
  point.position = position;
  point.normal = n;
  point.uv.x = mirrored ? 1.0 - turn_of(position) : turn_of(position);
  point.uv.y = has_height ? (y_upper - position.y) / height : -position.y;
  if (std::abs(outward) > 1e-6) {
    const DVec3 around = east - dot(n, east) / outward * out;
    point.dp_du = (mirrored ? -metres_per_u : metres_per_u) * around;
    point.dp_dv = metres_per_v * (n.y / outward * out - DVec3(0.0, 1.0, 0.0));
  } else {
    const DVec3 in_plane = east - dot(n, east) * n;
    const DVec3 along = length(in_plane) > 1e-3 ? normalize(in_plane) : out;
    point.dp_du = metres_per_u * along;
    point.dp_dv = metres_per_v * cross(along, n);
  }
  return point;
}

}  // namespace lume::geometry
