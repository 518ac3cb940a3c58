// SPDX-License-Identifier: Apache-2.0
// All surfaces that are met by a formula and not by triangles. Each is one file with the same four
// members: support() for its bounds, intersect() for the first crossing, point() for the normal,
// texture coordinates and tangents there, and meets() where any crossing is cheaper than the first.
#pragma once

#include "geometry/bounds.h"
#include "geometry/shapes/bezier_surface.h"
#include "geometry/shapes/box.h"
#include "geometry/shapes/capsule.h"
#include "geometry/shapes/cylinder.h"
#include "geometry/shapes/implicit_surface.h"
#include "geometry/shapes/plane.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/quadric.h"
#include "geometry/shapes/sphere.h"
#include "geometry/shapes/torus.h"
#include "geometry/transform.h"

#include <variant>

namespace lume::geometry {

using Shape = std::variant<Plane, Disk, Box, Sphere, Cylinder, Capsule, Quadric, Polygon, Torus,
                           ImplicitSurface, BezierSurface>;

/// The first crossing on the ray, if there is one. A ray that is not finite, or has no direction,
/// crosses nothing.
[[nodiscard]] std::optional<Crossing> intersect(const Shape& shape, const ObjectRay& ray);

/// Whether there is any crossing on the ray.
[[nodiscard]] bool meets(const Shape& shape, const ObjectRay& ray);

/// The surface where the ray crosses it.
[[nodiscard]] ShapePoint shape_point(const Shape& shape, const ObjectRay& ray,
                                     const Crossing& crossing);

/// The same without texture coordinates and what depends on them, which cost more than the rest.
[[nodiscard]] ShapePoint shape_place(const Shape& shape, const ObjectRay& ray,
                                     const Crossing& crossing);

/// The box around the transformed shape: along each axis exactly what the shape's support() says,
/// rounded outwards. Infinite where the shape has no end.
[[nodiscard]] Bounds shape_bounds(const Shape& shape, const Transform& transform);

/// The name of the kind: "sphere".
[[nodiscard]] const char* shape_name(const Shape& shape);

}  // namespace lume::geometry
