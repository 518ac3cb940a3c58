// SPDX-License-Identifier: Apache-2.0
// A material at one point of a surface: its factors times its textures.
#pragma once

#include "geometry/surface_point.h"
#include "shading/scene.h"

namespace lume::shading {

struct MaterialPoint {
  const Material* material = nullptr;
  Color base_color{1.0f};
  float coverage = 1.0f;   ///< alpha: 1 for opaque materials, 0 or 1 for masked ones
  float metallic = 0.0f;   ///< this and the next four: of the metallic-roughness model only
  float roughness = 1.0f;  ///< perceptual, as glTF has it
  float transmission = 0.0f;
  float specular = 1.0f;       ///< strength of the dielectric reflection
  Color specular_color{1.0f};  ///< its tint at normal incidence

  float occlusion = 1.0f;  ///< of ambient light: 1 none
  /// Unit, with the normal map, on the side the viewer is on.
  Vec3 normal{0.0f};
};

/// Everything at once, for shading. `to_viewer` is a unit vector.
[[nodiscard]] MaterialPoint evaluate_material(const Scene& scene,
                                              const geometry::SurfacePoint& point,
                                              const Vec3& to_viewer);

/// Base colour and, in w, coverage.
[[nodiscard]] Vec4 evaluate_base_color(const Scene& scene, const geometry::SurfacePoint& point);

/// Coverage alone, without the rest of a SurfacePoint.
[[nodiscard]] float evaluate_coverage(const Scene& scene, const geometry::Hit& hit, Vec2 uv);

/// Light (nits) that the surface itself sends towards the side the ray came from. Back faces of
/// single-sided materials send none.
[[nodiscard]] Color evaluate_emission(const Scene& scene, const geometry::SurfacePoint& point);

}  // namespace lume::shading
