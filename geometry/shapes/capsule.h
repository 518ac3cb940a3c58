// SPDX-License-Identifier: Apache-2.0
// The capsule of glTF's implicit shapes: the convex hull of two spheres on the axis y. It is the
// spheres and the part of a cone that touches both.
#pragma once

#include "geometry/shapes/cylinder.h"
#include "geometry/shapes/cylindrical_point.h"

namespace lume::geometry {

class Capsule {
 public:
  /// `height` is the distance of the centres, at y = -height / 2 and y = +height / 2.
  Capsule(double height, double radius_bottom, double radius_top);

  /// The largest dot(p, direction) over all points p.
  [[nodiscard]] double support(const DVec3& direction) const;
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const;
  /// u once around, v evenly in y from the top to the bottom.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const;

 private:
  enum Part : std::uint32_t { side, bottom, top };
  struct Ball {
    double y = 0.0;
    double radius = 0.0;
  };

  Ball bottom_;
  Ball top_;
  Cylinder side_;         ///< between the circles where the cone touches the spheres
  double side_y_ = 0.0;   ///< of its middle
  bool has_side_ = true;  ///< false if one sphere contains the other
};

}  // namespace lume::geometry
