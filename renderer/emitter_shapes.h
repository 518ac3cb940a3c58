// SPDX-License-Identifier: Apache-2.0
// How shadow rays are aimed at shapes that are met by a formula: spheres by direction, rectangles
// and disks by area. There is no aiming at any other shape, nor at a plane without an end.
#pragma once

#include "geometry/shapes/shape.h"

namespace lume::renderer {

/// The functions below are for these shapes only.
[[nodiscard]] bool is_area_light(const geometry::Shape& shape);

/// A point of the shape in its object's space, uniform over its area there.
[[nodiscard]] geometry::ShapePoint uniform_point(const geometry::Shape& shape,
                                                 geometry::Vec2 random);

/// m^2 in the scene's frame.
[[nodiscard]] double world_area(const geometry::Shape& shape, const geometry::Transform& transform);

/// A point of the sphere in its object's space, such that its direction from `from` (also there) is
/// uniform over all directions that meet the sphere: a cone from outside, all from inside.
[[nodiscard]] geometry::ShapePoint point_seen_from(const geometry::Sphere& sphere,
                                                   const geometry::DVec3& from,
                                                   geometry::Vec2 random);

/// The density of the direction to that point, per steradian of directions in the scene's frame.
/// All vectors are in the scene's frame, `normal` is on the sphere's outside. 0 for the far side,
/// which the near side hides.
[[nodiscard]] double direction_pdf(const geometry::Sphere& sphere,
                                   const geometry::Transform& transform,
                                   const geometry::DVec3& position, const geometry::DVec3& normal,
                                   const geometry::DVec3& from);

}  // namespace lume::renderer
