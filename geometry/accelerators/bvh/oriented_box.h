// SPDX-License-Identifier: Apache-2.0
// The box that is turned to fit what is in it (Gottschalk, Lin, Manocha 1996, "OBBTree: A
// Hierarchical Structure for Rapid Interference Detection"): tight around what is flat or long,
// wherever it points, but three times as long to meet.
#pragma once

#include "geometry/accelerators/bvh/slack.h"
#include "geometry/accelerators/bvh/tree.h"
#include "geometry/accelerators/slab.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace lume::geometry::bvh {

/// A ray made ready for boxes that are turned.
struct OrientedRay {
  OrientedRay(const ObjectRay& ray, const Bounds& all)
      : origin(ray.origin), direction(ray.direction), slack(slack_of(ray, all)) {}

  DVec3 origin;
  DVec3 direction;
  double slack;
};

/// Three slabs: lower[i] <= dot(axes[i], p) <= upper[i]. Nothing relies on the axes being unit
/// vectors at right angles to the last digit, so floats will do.
struct OrientedBox {
  using Ray = OrientedRay;
  static constexpr bool k_needs_points = true;

  /// Along the points' principal axes, or along the axes of space if that box has less surface.
  static OrientedBox around(const Bounds& box, std::span<const Vec3> points);

  /// Heights, of the ray as of the points that the slabs were put around, are sums of three
  /// products: each is off by less than 4 * 2^-53 of the coordinates' sum. The slope is off by that
  /// of the direction's, which at a point of the structure comes to the same.
  [[nodiscard]] Interval1D clip(const OrientedRay& ray, double t_min, double t_max) const {
    Interval1D result{t_min, t_max};
    for (int i = 0; i < 3; ++i) {
      const DVec3 axis(axes[i]);
      const double height = dot(axis, ray.origin);
      const double inverse = inverse_slope(dot(axis, ray.direction));
      const double a = (lower[i] - height - ray.slack) * inverse;
      const double b = (upper[i] - height + ray.slack) * inverse;
      result.enter = std::max(result.enter, std::min(a, b));
      result.leave = std::min(result.leave, std::max(a, b));
    }
    return result;
  }

  std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  DVec3 lower{0.0};
  DVec3 upper{0.0};

 private:
  static double inverse_slope(double slope) {
    constexpr double k_flattest = 1e-150;  // as good as along the slab for all its length
    return 1.0 / (std::abs(slope) < k_flattest ? std::copysign(k_flattest, slope) : slope);
  }
};

[[nodiscard]] inline double half_area(const OrientedBox& box) {
  const DVec3 size = box.upper - box.lower;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace lume::geometry::bvh
