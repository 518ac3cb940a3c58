// SPDX-License-Identifier: Apache-2.0
// A planar polygon with any number of corners, concave and with holes. The point where the ray
// meets its plane is dropped along the dominant axis of the normal, and is inside if a line from it
// crosses the outline an odd number of times (Jordan).
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/shape_point.h"

#include <optional>
#include <vector>

namespace lume::geometry {

class Polygon {
 public:
  /// `loops` are closed outlines of at least three corners, the first the outer one; a point is
  /// inside by the even-odd rule. The front is where the first loop is counter-clockwise. Its
  /// corners must span a plane; corners off that plane are dropped onto it.
  explicit Polygon(std::vector<std::vector<DVec3>> loops);

  /// The unit normal of a loop by Newell's method; (0, 0, 0) if it spans no area.
  [[nodiscard]] static DVec3 normal_of(const std::vector<DVec3>& loop);

  /// The largest dot(p, direction) over all points p.
  [[nodiscard]] double support(const DVec3& direction) const;
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const;
  /// The image covers the polygon's bounding rectangle in its plane.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const;

 private:
  struct Edge {
    DVec2 from;
    DVec2 to;
  };
  [[nodiscard]] bool is_inside(const DVec2& p) const;

  DVec3 normal_{0.0};      ///< unit
  double distance_ = 0.0;  ///< d of n.x = d
  int axis_u_ = 0;         ///< the two axes that are kept
  int axis_v_ = 1;
  std::vector<Edge> edges_;  ///< projected
  std::vector<DVec3> corners_;
  DVec3 right_{1.0, 0.0, 0.0};  ///< unit, in the plane: the image's u
  DVec3 down_{0.0, 0.0, 1.0};   ///< unit, in the plane: the image's v
  DVec2 image_origin_{0.0};     ///< along right_ and down_ (metres)
  DVec2 image_size_{1.0};
};

}  // namespace lume::geometry
