// SPDX-License-Identifier: Apache-2.0
// The one place where a ray meets geometry: t, u, v from the primitive itself, whatever accelerator
// named it.
#pragma once

#include "geometry/hit.h"
#include "geometry/ray.h"
#include "geometry/world.h"

namespace lume::geometry {

/// Where the line of a ray crosses a triangle, in the triangle's object space and in double.
struct Crossing {
  double t = 0.0;
  double u = 0.0;  ///< barycentric coordinate of corner 1
  double v = 0.0;  ///< barycentric coordinate of corner 2
  bool inside =
      false;  ///< the line passes through the triangle (edges included) and is not in its plane
};

/// The watertight ray/triangle test of Woop, Benthin and Wald 2013 ("Watertight Ray/Triangle
/// Intersection", JCGT 2(1)), carried out in double. `inside` alone says whether the line meets the
/// triangle; t, u and v are then exact to double rounding. Where it does not, t, u, v are those of
/// the nearest point that is in the triangle, so that a hit which a float accelerator reported one
/// rounding beyond an edge still lies on its primitive.
[[nodiscard]] Crossing intersect_triangle(const DVec3& origin, const DVec3& direction,
                                          const DVec3& a, const DVec3& b, const DVec3& c);

/// The crossing of a world ray with the primitive that an accelerator named.
[[nodiscard]] Crossing refine(const World& world, const Ray& ray, const Hit& hit);

}  // namespace lume::geometry
