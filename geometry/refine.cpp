// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::geometry {
namespace {

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

TriangleCrossing nearest_on_triangle(const DVec3& origin, const DVec3& direction, const DVec3& a,
                                     const DVec3& b, const DVec3& c) {
  const ShearedRay ray(origin, direction);
  const TriangleCrossing crossing = intersect_triangle(ray, a, b, c);
  if (crossing.inside) return crossing;
  return clamp_to_triangle(TriangleWeights(ray, a, b, c).of_corner, origin, direction, a, b, c);
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
      nearest_on_triangle(object_ray.origin, object_ray.direction, DVec3(corners[0]),
                          DVec3(corners[1]), DVec3(corners[2]));
  return {crossing.t, crossing.u, crossing.v};
}

}  // namespace lume::geometry
