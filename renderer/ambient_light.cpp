// SPDX-License-Identifier: Apache-2.0
#include "renderer/ambient_light.h"

#include "renderer/shadow.h"
#include "shading/warp.h"

namespace lume::renderer {
namespace {

constexpr std::uint32_t k_occlusion_dimension = 3;

/// 1 if nothing stands within `distance` in the direction drawn, 0 if something does, between where
/// that is see-through.
float sample_occlusion(const PreparedScene& prepared, const ShadedPoint& point, float distance,
                       const Sampler& sampler, RayCounts& counts) {
  const Vec3 local = shading::sample_cosine_hemisphere(sampler.get_2d(k_occlusion_dimension));
  const Vec3 direction = geometry::make_frame(point.material.normal).to_world(local);
  if (!point.is_above(direction)) return 0.0f;
  geometry::Ray ray = shadow_ray_along(point.surface, direction);
  ray.t_max = distance;
  return shading::luminance(trace_shadow(prepared, ray, counts).color);
}

}  // namespace

AmbientLight ambient_light(const PreparedScene& prepared, const ShadedPoint& point, float distance,
                           const Sampler& sampler, RayCounts& counts) {
  AmbientLight result;
  const Color& ambient = prepared.scene().ambient;
  if (ambient == Color(0.0f)) return result;
  result.color = ambient * point.bsdf.ambient();
  if (result.color == Color(0.0f)) return result;
  if (distance > 0.0f) {
    result.unoccluded = sample_occlusion(prepared, point, distance, sampler, counts);
  }
  result.color *= point.material.occlusion * result.unoccluded;
  return result;
}

}  // namespace lume::renderer
