// SPDX-License-Identifier: Apache-2.0
// The sphere as the volume of a hierarchy (Whitted 1980, "An Improved Illumination Model for Shaded
// Display"; Weghorst, Hooper, Greenberg 1984, "Improved Computational Methods for Ray Tracing"):
// cheaply met and the same from all sides, but wide around what is flat or long.
#pragma once

#include "geometry/accelerators/bvh/slack.h"
#include "geometry/accelerators/bvh/tree.h"
#include "geometry/accelerators/slab.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace lume::geometry::bvh {

/// A ray made ready for spheres.
struct SphereRay {
  SphereRay(const ObjectRay& ray, const Bounds& all)
      : origin(ray.origin),
        direction(ray.direction),
        // A ray without a direction stays where it is for all t.
        inverse_square(1.0 / std::max(dot(direction, direction), 1e-300)),
        inverse_length(std::sqrt(inverse_square)),
        slack(slack_of(ray, all)) {}

  DVec3 origin;
  DVec3 direction;
  double inverse_square;  ///< of the direction's length
  double inverse_length;
  double slack;
};

struct BoundingSphere {
  using Ray = SphereRay;
  static constexpr bool k_needs_points = true;

  /// The smaller one of Ritter's sphere (1990, "An Efficient Bounding Sphere", Graphics Gems) and
  /// that around the box's center, each no larger than the points ask for.
  static BoundingSphere around(const Bounds& box, std::span<const Vec3> points);

  /// With F the distance of the center from the origin and u = 2^-53: t_center is off by less than
  /// 8 u F / |direction|, and `across`, the way from the ray to the center, by less than 11 u F.
  /// A radius that is larger by 19 u (F + radius) makes up for both, the slack for much more.
  [[nodiscard]] Interval1D clip(const SphereRay& ray, double t_min, double t_max) const {
    const DVec3 to_center = center - ray.origin;
    const double t_center = dot(to_center, ray.direction) * ray.inverse_square;
    const DVec3 across = to_center - t_center * ray.direction;
    const double wide = radius + ray.slack;
    const double square = wide * wide - dot(across, across);
    if (!(square >= 0.0)) return {1.0, 0.0};
    const double half_chord = std::sqrt(square) * ray.inverse_length;
    return {std::max(t_min, t_center - half_chord), std::min(t_max, t_center + half_chord)};
  }

  DVec3 center{0.0};
  double radius = 0.0;
};

/// Half the surface, to compare with boxes.
[[nodiscard]] inline double half_area(const BoundingSphere& sphere) {
  return 2.0 * std::numbers::pi * sphere.radius * sphere.radius;
}

}  // namespace lume::geometry::bvh
