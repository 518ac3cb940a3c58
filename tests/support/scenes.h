// SPDX-License-Identifier: Apache-2.0
// Small scenes whose light can be calculated by hand.
#pragma once

#include "shading/scene.h"
#include "tests/support/worlds.h"

#include <utility>

namespace lume::test {

/// Adds a mesh or a shape with a material of its own; returns the material to be filled in.
template <class Surface>
shading::Material& add_surface(shading::Scene& scene, Surface surface,
                               const geometry::DMat4& transform = geometry::DMat4(1.0)) {
  add_instance(scene.world, std::move(surface), transform);
  scene.world.objects.back().geometries[0].material =
      static_cast<std::uint32_t>(scene.materials.size());
  return scene.materials.emplace_back();
}

/// A matte material without any specular reflection: index of refraction 1.
inline void make_matte(shading::Material& material, const shading::Color& albedo) {
  material.base_color = albedo;
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.ior = 1.0f;
}

inline geometry::DMat4 translation(double x, double y, double z) {
  geometry::DMat4 matrix(1.0);
  matrix[3] = glm::dvec4(x, y, z, 1.0);
  return matrix;
}

}  // namespace lume::test
