// SPDX-License-Identifier: Apache-2.0
#include "renderer/branch.h"

#include "renderer/ambient_light.h"

namespace lume::renderer {
namespace {

/// Emitted light, shared with the shadow rays of the surface that the branch was reflected by.
Color emission(const PreparedScene& prepared, const Branch& branch,
               const geometry::SurfacePoint& point) {
  const Color emitted = shading::evaluate_emission(prepared.scene(), point);
  if (branch.pdf <= 0.0f || emitted == Color(0.0f)) return emitted;
  const Vec3 from = branch.ray.origin - branch.travelled * branch.ray.direction;
  return emitted * balance(branch.pdf, prepared.emitters().pdf(point, from));
}

}  // namespace

std::optional<Color> backdrop(const PreparedScene& prepared, const Branch& branch) {
  const shading::Scene& scene = prepared.scene();
  const bool is_camera_ray = branch.depth == 0;
  if (!scene.environment || (is_camera_ray && !scene.environment->visible)) return scene.background;
  const Vec3& direction = branch.ray.direction;
  const Color radiance = scene.environment->radiance(direction);
  if (branch.pdf <= 0.0f) return radiance;
  return radiance * balance(branch.pdf, environment_pdf(prepared, branch.aim, direction));
}

void local_light(const PreparedScene& prepared, const Branch& branch, const ShadedPoint& point,
                 const IntegratorSettings& settings, const Sampler& sampler, Ledger& ledger,
                 SurfaceNote* note, Radiance& result) {
  if (point.material.material->unlit) {
    result.terms.emitted = point.material.base_color;
    return;
  }
  result.terms.emitted = emission(prepared, branch, point.surface);
  const AmbientLight ambient =
      ambient_light(prepared, point, settings.occlusion_distance, sampler, ledger.counts);
  result.terms.ambient = ambient.color;
  if (note != nullptr) {
    note->unoccluded = ambient.unoccluded;
    note->first_light = ledger.tree->lights.size();
  }
  const DirectLight direct = direct_light(prepared, point, settings.shadows, sampler, ledger);
  result.terms.diffuse = direct.diffuse;
  result.terms.specular = direct.specular;
  result.shadow = direct.shadow;
  if (note != nullptr) note->light_count = ledger.tree->lights.size() - note->first_light;
}

}  // namespace lume::renderer
