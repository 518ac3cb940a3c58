// SPDX-License-Identifier: Apache-2.0
// The torus around y, (|x|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2): a quartic along a ray.
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/shape_point.h"

#include <optional>

namespace lume::geometry {

struct Torus {
  double major_radius = 0.375;  ///< from the axis to the middle of the tube (metres)
  double minor_radius = 0.125;  ///< of the tube; at most the major one

  /// The largest dot(p, direction) over all points p.
  [[nodiscard]] double support(const DVec3& direction) const;
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const;
  /// u once around the axis, v once around the tube, from the top over the outside (0.25) to the
  /// bottom (0.5) and back over the inside.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const;
};

}  // namespace lume::geometry
