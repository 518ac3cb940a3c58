// SPDX-License-Identifier: Apache-2.0
// Where a primitive may be seen in the picture, and how near. All answers are on the safe side of
// what may be rounded, here or in the test of a ray against the primitive itself.
//
// By a perspective camera, a triangle is seen where a ray is inside of three planes through the eye
// and two corners each (Olano and Greer 1997, "Triangle Scan Conversion using 2D Homogeneous
// Coordinates"); so one that is partly behind the camera need not be clipped.
#pragma once

#include "geometry/accelerators/zbuffer/view.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lume::geometry::zbuffer {

/// x at.x + y at.y + constant. Over a rectangle its extremes are in two of the corners.
struct Affine {
  double x = 0.0;
  double y = 0.0;
  double constant = 0.0;

  [[nodiscard]] double most(const Rect& rect) const {
    return x * (x > 0.0 ? rect.upper : rect.lower).x + y * (y > 0.0 ? rect.upper : rect.lower).y +
           constant;
  }
  [[nodiscard]] double least(const Rect& rect) const {
    return x * (x > 0.0 ? rect.lower : rect.upper).x + y * (y > 0.0 ? rect.lower : rect.upper).y +
           constant;
  }
};

/// Nearness is 1 / depth by a perspective camera and -depth by an orthographic one: what grows
/// towards the eye and is affine over the picture of a plane.
struct Footprint {
  static constexpr double k_infinity = std::numeric_limits<double>::infinity();

  struct Edge {
    Affine inside;  ///< above 0 on the side of the triangle
    double slack = k_infinity;
  };

  /// Whether a ray through the rectangle, which overlaps `bounds`, may meet the primitive.
  [[nodiscard]] bool touches(const Rect& rect) const {
    return std::all_of(edges.begin(), edges.end(),
                       [&rect](const Edge& edge) { return edge.inside.most(rect) >= -edge.slack; });
  }
  /// Whether each ray through the rectangle is certain to meet the primitive.
  [[nodiscard]] bool covers(const Rect& rect) const {
    return is_solid && std::all_of(edges.begin(), edges.end(), [&rect](const Edge& edge) {
             return edge.inside.least(rect) > edge.slack;
           });
  }
  /// How near the primitive is at most where it is met in the rectangle, and at least.
  [[nodiscard]] double nearest(const Rect& rect) const {
    return std::min(nearest_corner, nearness.most(rect) + nearness_slack);
  }
  [[nodiscard]] double farthest(const Rect& rect) const {
    return nearness.least(rect) - nearness_slack;
  }

  Rect bounds;  ///< around all of it
  std::array<Edge, 3> edges;
  Affine nearness;
  double nearness_slack = k_infinity;
  double nearest_corner = k_infinity;  ///< nearness; infinite where the camera's plane cuts through
  bool is_solid = false;               ///< without holes, in front of the camera, and not edge-on
};

}  // namespace lume::geometry::zbuffer
