// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::geometry {
namespace {

/// The axis along which a vector is longest.
int dominant_axis(const DVec3& v) {
  const DVec3 size = glm::abs(v);
  if (size.x > size.y) return size.x > size.z ? 0 : 2;
  return size.y > size.z ? 1 : 2;
}

/// Completes a crossing whose edge functions (weights of the corners a, b, c) do not all have the
/// same sign: the weights are clamped into the triangle, and t is the line's nearest approach.
TriangleCrossing clamp_to_triangle(DVec3 weights, const DVec3& origin, const DVec3& direction,
                                   const DVec3& a, const DVec3& b, const DVec3& c) {
  if (weights.x + weights.y + weights.z < 0.0) weights = -weights;
  weights = glm::max(weights, DVec3(0.0));
  const double sum = weights.x + weights.y + weights.z;
  weights = sum > 0.0 ? weights / sum : DVec3(1.0 / 3.0);  // a degenerate triangle: its middle
  const DVec3 point = weights.x * a + weights.y * b + weights.z * c;
  return {dot(point - origin, direction) / dot(direction, direction), weights.y, weights.z, false};
}

}  // namespace

TriangleCrossing intersect_triangle(const DVec3& origin, const DVec3& direction, const DVec3& a,
                                    const DVec3& b, const DVec3& c) {
  // Permute so that the ray runs mostly along z, and shear so that it runs exactly along z
  // (section 3.1). The permutation keeps the winding when the ray runs along -z.
  const int kz = dominant_axis(direction);
  int kx = (kz + 1) % 3;
  int ky = (kx + 1) % 3;
  if (direction[kz] < 0.0) std::swap(kx, ky);
  const double shear_x = direction[kx] / direction[kz];
  const double shear_y = direction[ky] / direction[kz];

  const DVec3 pa = a - origin;
  const DVec3 pb = b - origin;
  const DVec3 pc = c - origin;
  const double ax = pa[kx] - shear_x * pa[kz];
  const double ay = pa[ky] - shear_y * pa[kz];
  const double bx = pb[kx] - shear_x * pb[kz];
  const double by = pb[ky] - shear_y * pb[kz];
  const double cx = pc[kx] - shear_x * pc[kz];
  const double cy = pc[ky] - shear_y * pc[kz];

  // Edge functions: twice the signed areas opposite the corners, so the corners' weights. A shared
  // edge has the same products in both of its triangles, hence no ray slips between them.
  const DVec3 weights(cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax);
  const double determinant = weights.x + weights.y + weights.z;
  const bool negative = weights.x < 0.0 || weights.y < 0.0 || weights.z < 0.0;
  const bool positive = weights.x > 0.0 || weights.y > 0.0 || weights.z > 0.0;
  if ((negative && positive) || determinant == 0.0) {
    return clamp_to_triangle(weights, origin, direction, a, b, c);
  }
  const double t = (weights.x * pa[kz] + weights.y * pb[kz] + weights.z * pc[kz]) /
                   (determinant * direction[kz]);
  return {t, weights.y / determinant, weights.z / determinant, true};
}

std::optional<Crossing> first_crossing_beside_holes(const Shape& shape, const ObjectRay& ray,
                                                    const Hit& hit, const HoleTest& holes) {
  std::optional<Crossing> crossing = intersect(shape, ray);
  ObjectRay rest = ray;
  while (crossing) {
    const Hit there{hit.instance, hit.geometry, crossing->part};
    if (!holes.is_hole(there, Vec2(shape_point(shape, ray, *crossing).uv))) break;
    rest.t_min = std::nextafter(crossing->t, std::numeric_limits<double>::infinity());
    crossing = intersect(shape, rest);
  }
  return crossing;
}

Crossing refine(const World& world, const Ray& ray, const Hit& hit, const HoleTest* holes) {
  const ObjectRay object_ray = to_object(world.transform(hit), ray);
  const Geometry& geometry = world.geometry(hit);
  const Mesh* mesh = geometry.mesh();
  if (mesh == nullptr) {
    // The accelerator met it by the same formula with the same numbers, so it is there.
    return first_crossing(geometry, object_ray, hit, holes).value_or(Crossing());
  }
  const auto corners = mesh->corners(hit.primitive);
  const TriangleCrossing crossing =
      intersect_triangle(object_ray.origin, object_ray.direction, DVec3(corners[0]),
                         DVec3(corners[1]), DVec3(corners[2]));
  return {crossing.t, crossing.u, crossing.v};
}

}  // namespace lume::geometry
