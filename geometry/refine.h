// SPDX-License-Identifier: Apache-2.0
// The one place where a ray meets geometry: t, u, v from the primitive itself, whatever accelerator
// named it.
#pragma once

#include "geometry/crossing.h"
#include "geometry/hole_test.h"
#include "geometry/ray.h"
#include "geometry/shapes/triangle.h"
#include "geometry/world.h"

#include <optional>

namespace lume::geometry {

/// The crossing of a ray's line with a triangle, or where there is none, with `inside` false, the
/// nearest point that is in the triangle, so that a hit which a float accelerator reported one
/// rounding beyond an edge still lies on its primitive.
[[nodiscard]] TriangleCrossing nearest_on_triangle(const DVec3& origin, const DVec3& direction,
                                                   const DVec3& a, const DVec3& b, const DVec3& c);

/// A world ray taken into the space of an instance.
[[nodiscard]] inline ObjectRay to_object(const Transform& transform, const Ray& ray) {
  return {transform.point_to_object(DVec3(ray.origin)),
          transform.vector_to_object(DVec3(ray.direction)), ray.t_min, ray.t_max};
}

/// The first crossing of the ray with a shape that has holes. hit.primitive is not looked at.
[[nodiscard]] std::optional<Crossing> first_crossing_beside_holes(const Shape& shape,
                                                                  const ObjectRay& ray,
                                                                  const Hit& hit,
                                                                  const HoleTest& holes);

/// The first crossing of the ray with a shape that is not a hole there. `geometry` is that of
/// `hit`, whose primitive is not looked at; `holes` may be null.
[[nodiscard]] inline std::optional<Crossing> first_crossing(const Geometry& geometry,
                                                            const ObjectRay& ray, const Hit& hit,
                                                            const HoleTest* holes) {
  return geometry.has_holes && holes != nullptr
             ? first_crossing_beside_holes(*geometry.shape(), ray, hit, *holes)
             : intersect(*geometry.shape(), ray);
}

/// The crossing of a world ray with the primitive that an accelerator named; `holes` must be those
/// that the accelerator knew.
[[nodiscard]] Crossing refine(const World& world, const Ray& ray, const Hit& hit,
                              const HoleTest* holes);

}  // namespace lume::geometry
