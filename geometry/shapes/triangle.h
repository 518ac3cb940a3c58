// SPDX-License-Identifier: Apache-2.0
// A ray against a triangle, watertight: of a closed mesh every ray from inside meets something.
#pragma once

#include "geometry/crossing.h"

#include <utility>

namespace lume::geometry {

/// A ray made ready for many triangles: coordinates are permuted so that it runs mostly along z,
/// and sheared so that it runs exactly along z (Woop, Benthin and Wald 2013, "Watertight
/// Ray/Triangle Intersection", JCGT 2(1), section 3.1).
struct ShearedRay {
  ShearedRay(const DVec3& ray_origin, const DVec3& direction)
      : origin(ray_origin), z(dominant_axis(direction)), x((z + 1) % 3), y((x + 1) % 3) {
    // The permutation keeps the winding when the ray runs along -z.
    if (direction[z] < 0.0) std::swap(x, y);
    shear_x = direction[x] / direction[z];
    shear_y = direction[y] / direction[z];
    length_z = direction[z];
  }

  DVec3 origin;
  int z = 0;  ///< the axis along which the ray is longest
  int x = 0;
  int y = 0;
  double shear_x = 0.0;
  double shear_y = 0.0;
  double length_z = 0.0;  ///< the direction's component along z
};

/// The edge functions of a triangle around a ray: twice the signed areas opposite its corners, so
/// the corners' weights. A shared edge has the same products in both of its triangles, hence no ray
/// slips between them.
struct TriangleWeights {
  TriangleWeights(const ShearedRay& ray, const DVec3& a, const DVec3& b, const DVec3& c) {
    const DVec3 pa = a - ray.origin;
    const DVec3 pb = b - ray.origin;
    const DVec3 pc = c - ray.origin;
    const double ax = pa[ray.x] - ray.shear_x * pa[ray.z];
    const double ay = pa[ray.y] - ray.shear_y * pa[ray.z];
    const double bx = pb[ray.x] - ray.shear_x * pb[ray.z];
    const double by = pb[ray.y] - ray.shear_y * pb[ray.z];
    const double cx = pc[ray.x] - ray.shear_x * pc[ray.z];
    const double cy = pc[ray.y] - ray.shear_y * pc[ray.z];
    of_corner = {cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax};
    z = {pa[ray.z], pb[ray.z], pc[ray.z]};
  }

  /// The line passes through the triangle, edges included, and is not in its plane.
  [[nodiscard]] bool surround_line() const {
    const DVec3& w = of_corner;
    const bool negative = w.x < 0.0 || w.y < 0.0 || w.z < 0.0;
    const bool positive = w.x > 0.0 || w.y > 0.0 || w.z > 0.0;
    return !(negative && positive) && sum() != 0.0;
  }
  [[nodiscard]] double sum() const { return of_corner.x + of_corner.y + of_corner.z; }

  DVec3 of_corner;
  DVec3 z;  ///< of the corners, from the ray's origin
};

/// Where the line of a ray crosses a triangle, in the triangle's object space and in double.
struct TriangleCrossing {
  double t = 0.0;
  double u = 0.0;  ///< barycentric coordinate of corner 1
  double v = 0.0;  ///< barycentric coordinate of corner 2
  /// The line passes through the triangle (edges included) and is not in its plane.
  bool inside = false;
};

/// t, u and v are exact to double rounding where the line meets the triangle, and 0 where it does
/// not. t lies between those of the corners, whatever is rounded.
[[nodiscard]] inline TriangleCrossing intersect_triangle(const ShearedRay& ray, const DVec3& a,
                                                         const DVec3& b, const DVec3& c) {
  const TriangleWeights weights(ray, a, b, c);
  if (!weights.surround_line()) return {};
  const double determinant = weights.sum();
  const DVec3& w = weights.of_corner;
  const double t =
      (w.x * weights.z.x + w.y * weights.z.y + w.z * weights.z.z) / (determinant * ray.length_z);
  return {t, w.y / determinant, w.z / determinant, true};
}

}  // namespace lume::geometry
