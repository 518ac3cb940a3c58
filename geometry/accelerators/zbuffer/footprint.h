// SPDX-License-Identifier: Apache-2.0
// Where a primitive may be seen in the picture, and how near. All answers are on the safe side of
// what may be rounded, here or in the test of a ray against the primitive itself.
#pragma once

#include "geometry/accelerators/zbuffer/view.h"
#include "geometry/transform.h"

#include <array>
#include <limits>
#include <optional>

namespace lume::geometry::zbuffer {

/// x * at.x + y * at.y + constant, whose extremes over a rectangle are in its corners.
struct Affine {
  double x = 0.0;
  double y = 0.0;
  double constant = 0.0;

  [[nodiscard]] double most(const Rect& rect) const {
    return constant + x * (x > 0.0 ? rect.upper : rect.lower).x +
           y * (y > 0.0 ? rect.upper : rect.lower).y;
  }
  [[nodiscard]] double least(const Rect& rect) const {
    return constant + x * (x > 0.0 ? rect.lower : rect.upper).x +
           y * (y > 0.0 ? rect.lower : rect.upper).y;
  }
};

/// Nearness is 1 / depth for a perspective camera and -depth for an orthographic one: what grows
/// towards the eye, and is an affine function on the picture of a plane.
class Footprint {
 public:
  /// Around all there is to be seen.
  [[nodiscard]] const Rect& bounds() const { return bounds_; }

  /// Whether a ray through the rectangle may meet the primitive.
  [[nodiscard]] bool touches(const Rect& rect) const {
    if (!overlaps(rect)) return false;
    if (!has_plane_) return true;
    for (const Edge& edge : edges_) {
      if (edge.inside.most(rect) < -edge.slack) return false;
    }
    return true;
  }
  /// Whether each ray through the rectangle is certain to meet the primitive.
  [[nodiscard]] bool covers(const Rect& rect) const {
    if (!is_solid_) return false;
    for (const Edge& edge : edges_) {
      if (!(edge.inside.least(rect) > edge.slack)) return false;
    }
    return farthest(rect) > least_nearness_;
  }

  /// How near the primitive is at most where it is met in the rectangle, and at least.
  [[nodiscard]] double nearest(const Rect& rect) const {
    if (!has_plane_) return nearest_;
    return std::min(nearest_, nearness_.most(rect) + nearness_slack_);
  }
  [[nodiscard]] double farthest(const Rect& rect) const {
    return nearness_.least(rect) - nearness_slack_;
  }

 private:
  friend class Projector;

  struct Edge {
    Affine inside;  ///< above 0 on the side of the triangle
    double slack = 0.0;
  };

  [[nodiscard]] bool overlaps(const Rect& rect) const {
    return bounds_.lower.x <= rect.upper.x && bounds_.upper.x >= rect.lower.x &&
           bounds_.lower.y <= rect.upper.y && bounds_.upper.y >= rect.lower.y;
  }

  Rect bounds_;
  std::array<Edge, 3> edges_;
  Affine nearness_;
  double nearness_slack_ = 0.0;
  double nearest_ = std::numeric_limits<double>::infinity();
  double least_nearness_ = 0.0;  ///< of what can cover: rays must have begun before
  bool has_plane_ = false;       ///< that it is not seen from the side; else only bounds_ are known
  bool is_solid_ = false;        ///< a triangle without holes, all of it before the rays' beginnings
};

/// Projects what is in the space of one instance.
class Projector {
 public:
  Projector(const View& view, const Transform& transform);

  /// None if no ray of the camera meets it.
  [[nodiscard]] std::optional<Footprint> triangle(const std::array<Vec3, 3>& corners,
                                                  bool is_solid) const;
  /// Of whatever is in a box.
  [[nodiscard]] std::optional<Footprint> box(const Bounds& bounds) const;

 private:
  /// A corner as the camera sees it.
  struct Corner {
    DVec3 way{0.0};      ///< from the eye, in object space
    DVec3 place{0.0};    ///< as View::to_cells
    double error = 0.0;  ///< of each component of `place`
  };

  [[nodiscard]] Corner see(const Vec3& point) const;
  /// Completes bounds_ and nearest_. False: all corners are behind the camera.
  template <std::size_t count>
  bool frame(const std::array<Corner, count>& corners, Footprint& result) const;
  void add_edges(const std::array<Corner, 3>& corners, Footprint& result) const;
  void add_edges_perspective(const std::array<Corner, 3>& corners, const DVec3& normal,
                             double area, Footprint& result) const;
  void add_edges_orthographic(const std::array<Corner, 3>& corners, const DVec3& normal,
                              double area, Footprint& result) const;

  const View& view_;
  DVec3 eye_;
  DMat3 to_cells_;
  double rounding_ = 0.0;  ///< relative
  double scale_ = 0.0;     ///< at most by how much to_cells_ makes vectors longer
  double far_ = 0.0;       ///< size of what cancels out between the eye and the object's origin
  double ray_size_ = 1.0;  ///< of the longest (x, y, 1) in the picture
};

}  // namespace lume::geometry::zbuffer
