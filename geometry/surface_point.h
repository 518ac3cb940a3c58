// SPDX-License-Identifier: Apache-2.0
// Everything that shading needs to know of a place where a ray met a surface.
#pragma once

#include "geometry/hit.h"
#include "geometry/ray.h"
#include "geometry/refine.h"
#include "geometry/world.h"

namespace lume::geometry {

/// All vectors are in the scene's frame.
struct SurfacePoint {
  Hit hit;
  const Geometry* geometry = nullptr;
  float t = 0.0f;  ///< along the ray
  /// Of a triangle the barycentric coordinates of corners 1 and 2; of a shape texture coordinates,
  /// which like dp_du and dp_dv are there only where they were asked for.
  Vec2 uv{0.0f};
  Vec3 position{0.0f};          ///< on the surface, to half a unit in the last place
  Vec3 geometric_normal{0.0f};  ///< unit, towards the front: where triangles are counter-clockwise
  Vec3 normal{0.0f};            ///< unit, interpolated; on the same side as geometric_normal
  Vec3 dp_du{0.0f};             ///< of a shape: how its position changes with uv
  Vec3 dp_dv{0.0f};
  /// Where shadow rays start; `position` unless lift_shadow_origin() has raised it.
  Vec3 shadow_origin{0.0f};
  float offset = 0.0f;       ///< bound on any accelerator's error along the normal (metres)
  bool front_facing = true;  ///< the ray came from the side of geometric_normal

  /// Texture coordinates of a set; (0, 0) where a mesh has no such set. A shape has its own for all
  /// sets.
  [[nodiscard]] Vec2 texcoord(std::uint32_t set) const;
  /// Linear RGBA of the vertex colours; white where there are none.
  [[nodiscard]] Vec4 color() const;
};

/// Completes a refined hit. `crossing` must come from refine() of the same ray and hit. Without
/// `textured` a shape has no texture coordinates.
[[nodiscard]] SurfacePoint surface_point(const World& world, const Ray& ray, const Hit& hit,
                                         const Crossing& crossing, bool textured = true);

/// Moves point.shadow_origin to the curved surface that the vertex normals suggest, off the
/// triangle and towards the side the ray came from: shadow rays from there do not meet the facets
/// next door. Shapes are curved themselves and need no lift (Hanika 2021, "Hacking the Shadow
/// Terminator", Ray Tracing Gems II, chapter 4).
void lift_shadow_origin(const World& world, SurfacePoint& point);

/// The tangent frame in which a normal map on texture set `set` is given, around point.normal:
/// x along growing u, y along falling v (up in the image, as glTF 2.0, section 3.9.3, has it).
/// Taken from the mesh's tangents, or where it has none from the surface's own dP/du and dP/dv, of
/// the coordinates that `uv_transform` makes of the set's. A triangle without usable coordinates
/// gets an arbitrary frame.
[[nodiscard]] Frame tangent_frame(const World& world, const SurfacePoint& point, std::uint32_t set,
                                  const glm::mat2& uv_transform = glm::mat2(1.0f));

/// A ray from the point into `direction` that cannot meet the surface it leaves.
[[nodiscard]] Ray leave(const SurfacePoint& point, const Vec3& direction);

/// A shadow ray to a point at `target`; it ends just before it.
[[nodiscard]] Ray shadow_ray(const SurfacePoint& point, const Vec3& target);
/// A shadow ray to infinity along the unit vector `direction`.
[[nodiscard]] Ray shadow_ray_along(const SurfacePoint& point, const Vec3& direction);

}  // namespace lume::geometry
