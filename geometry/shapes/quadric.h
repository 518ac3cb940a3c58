// SPDX-License-Identifier: Apache-2.0
// The general quadric F(x, y, z) = p^T Q p = 0 with p = (x, y, z, 1) and a symmetric 4x4 matrix Q:
// ten coefficients for spheres, ellipsoids, cylinders, cones, paraboloids and hyperboloids alike
// (Blinn 1984, "The Algebraic Properties of Homogeneous Second Order Surfaces").
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/line.h"
#include "geometry/shapes/quadratic.h"
#include "geometry/shapes/shape_point.h"

#include <cmath>
#include <optional>

namespace lume::geometry {

class Quadric {
 public:
  enum Part : std::uint32_t { side, first_cap };  ///< cap of clip face i: first_cap + i (face.h)

  /// Where `q` must be symmetric. Only what lies in the box from `lower` to `upper`, whose
  /// coordinates may be infinite, is there. With caps it is the solid F <= 0 in the box, and the
  /// faces of the box close it.
  Quadric(const DMat4& q, const DVec3& lower, const DVec3& upper, bool caps);

  /// An upper bound of dot(p, direction) over all points p; infinity where there is none. Exact for
  /// an ellipsoid that the box leaves whole, of the tightest box to about 1% for all others.
  [[nodiscard]] double support(const DVec3& direction) const;
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const {
    const Along line = along(ray);
    if (caps_) return intersect_solid(ray, line);
    if (is_there(ray, line.t + line.first)) return Crossing{.t = line.t + line.first};
    if (is_there(ray, line.t + line.second)) return Crossing{.t = line.t + line.second};
    return std::nullopt;
  }
  /// On the side u around y, v from the top to the bottom of the box; caps as the faces of a box.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const;

  /// F and its gradient.
  [[nodiscard]] double value(const DVec3& p) const;
  [[nodiscard]] DVec3 gradient(const DVec3& p) const { return 2.0 * (squares_ * p + linear_); }

 private:
  /// F along a line: a t^2 + 2 b t + c, with t counted from `origin`, the ray's point at `t`.
  struct Along {
    double t;
    DVec3 origin;
    double a;
    double b;
    double c;
    double first;  ///< the roots, not a number if there are none
    double second;
  };
  [[nodiscard]] Along along(const ObjectRay& ray) const {
    const auto [t, o] = start_near(ray, middle_, size_);
    const DVec3& d = ray.direction;
    const DVec3 half_gradient = squares_ * o + linear_;
    const double a = dot(d, squares_ * d);
    const double b = dot(d, half_gradient);
    const double c = dot(o, half_gradient + linear_) + constant_;
    const auto [first, second] = solve_quadratic(a, b, c);
    return {t, o, a, b, c, first, second};
  }
  [[nodiscard]] bool is_in_box(const DVec3& p) const {
    return p.x >= lower_.x && p.x <= upper_.x && p.y >= lower_.y && p.y <= upper_.y &&
           p.z >= lower_.z && p.z <= upper_.z;
  }
  [[nodiscard]] bool is_there(const ObjectRay& ray, double t) const {
    return std::isfinite(t) && ray.contains(t) && is_in_box(ray.at(t));
  }
  [[nodiscard]] std::optional<Crossing> intersect_solid(const ObjectRay& ray,
                                                        const Along& line) const;
  void find_bounds();
  void find_ellipsoid();

  DMat3 squares_;  ///< F = p.(squares p) + 2 linear.p + constant
  DVec3 linear_;
  double constant_;
  DVec3 lower_;  ///< the box that cuts
  DVec3 upper_;
  bool caps_;
  DVec3 tight_lower_;  ///< the box around what is left; infinite where it has no end
  DVec3 tight_upper_;
  DVec3 middle_{0.0};  ///< around which lines are measured
  double size_ = 1.0;  ///< about that of the surface
  bool is_whole_ellipsoid_ = false;
  DMat3 ellipsoid_{0.0};  ///< support(d) = middle.d + sqrt(d.(ellipsoid d))
};

/// The named forms, in the box of half sizes `semi_axes` around the origin (metres), axis y, on
/// X = x / a, Y = y / b, Z = z / c. Cut and capped like any quadric.
enum class QuadricForm {
  ellipsoid,               ///< X^2 + Y^2 + Z^2 = 1
  cylinder,                ///< X^2 + Z^2 = 1
  cone,                    ///< X^2 + Z^2 = ((1 - Y) / 2)^2, the apex on top
  paraboloid,              ///< X^2 + Z^2 = (1 + Y) / 2, the vertex at the bottom
  hyperboloid_one_sheet,   ///< X^2 + Z^2 = w^2 + (1 - w^2) Y^2
  hyperboloid_two_sheets,  ///< Y^2 = w^2 + (1 - w^2) (X^2 + Z^2)
};

/// The matrix of a named form; `waist` is w in (0, 1).
[[nodiscard]] DMat4 quadric_matrix(QuadricForm form, const DVec3& semi_axes, double waist);

}  // namespace lume::geometry
