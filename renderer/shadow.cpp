// SPDX-License-Identifier: Apache-2.0
#include "renderer/shadow.h"

#include "shading/bsdf.h"
#include "shading/material_point.h"

#include <cmath>

namespace lume::renderer {

using shading::Color;

Color absorb(const shading::Material& material, float distance) {
  if (std::isinf(material.attenuation_distance)) return Color(1.0f);
  return glm::pow(material.attenuation_color, Color(distance / material.attenuation_distance));
}

namespace {

/// What is left of light that crosses a see-through surface where the shadow ray meets it.
/// `length_of_t` is that of the ray's direction.
Transmittance cross(const shading::Scene& scene, const geometry::SurfacePoint& point,
                    const geometry::Ray& ray, float length_of_t) {
  const Vec3 to_viewer = -ray.direction / length_of_t;
  const auto material = shading::evaluate_material(scene, point, to_viewer);
  Color passes = shading::straight_transmittance(material, dot(material.normal, to_viewer));
  Transmittance result;
  result.through_transmissive = material.coverage > 0.0f && shading::max_component(passes) > 0.0f;
  // Met from behind, the ray has been inside since the last crossing.
  if (material.material->is_solid() && !point.front_facing) {
    passes *= absorb(*material.material, point.t * length_of_t);
  }
  result.color = Color(1.0f - material.coverage) + material.coverage * passes;
  return result;
}

}  // namespace

Transmittance trace_shadow(const PreparedScene& prepared, geometry::Ray ray, RayCounts& counts) {
  constexpr int k_most_surfaces = 1000;
  constexpr Transmittance k_blocked{Color(0.0f), false};
  ++counts.shadow;
  if (!prepared.has_see_through() && !prepared.has_one_way()) {
    return prepared.accelerator().any_hit(ray) ? k_blocked : Transmittance();
  }
  const float length_of_t = length(ray.direction);
  Transmittance result;
  for (int surface = 0; surface < k_most_surfaces; ++surface) {
    const auto hit = prepared.accelerator().closest_hit(ray);
    if (!hit) return result;
    const shading::Material& material = prepared.material(*hit);
    if (!material.is_see_through() && !material.is_one_way()) return k_blocked;
    const geometry::SurfacePoint point = prepared.point_at(ray, *hit);
    const bool from_behind = material.is_one_way() && point.front_facing;
    if (!from_behind) {
      if (!material.is_see_through()) return k_blocked;
      const Transmittance crossing = cross(prepared.scene(), point, ray, length_of_t);
      result.color *= crossing.color;
      result.through_transmissive |= crossing.through_transmissive;
      if (shading::max_component(result.color) <= 0.0f) return k_blocked;
    }
    const float t_left = ray.t_max - point.t;
    if (!(t_left > 0.0f)) return result;
    ray = leave(point, ray.direction);
    ray.t_max = t_left;
  }
  return k_blocked;
}

}  // namespace lume::renderer
