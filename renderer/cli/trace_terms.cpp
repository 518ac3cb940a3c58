// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/trace_terms.h"

#include "shading/phong_equivalent.h"

#include <fmt/format.h>

#include <cmath>

namespace lume::cli {

using geometry::Vec3;
using renderer::LightNote;
using renderer::RayKind;
using renderer::RayNote;
using renderer::SurfaceNote;
using shading::Color;

std::string object_name(const shading::Scene& scene, const geometry::Hit& hit) {
  const geometry::Instance& instance = scene.world.instances[hit.instance];
  if (!instance.name.empty()) return instance.name;
  const std::string& object = scene.world.objects[instance.object].name;
  return object.empty() ? fmt::format("object {}", hit.instance) : object;
}

std::string material_name(const shading::Scene& scene, const geometry::Hit& hit) {
  const std::uint32_t material = scene.world.geometry(hit).material;
  const std::string& name = scene.materials[material].name;
  return name.empty() ? fmt::format("material {}", material) : name;
}

std::string light_name(const shading::Scene& scene, const LightNote& light) {
  if (light.kind == LightNote::Kind::environment) return "environment";
  if (light.kind == LightNote::Kind::emitter) return object_name(scene, light.emitter);
  const std::string& name = scene.lights[light.index].name;
  return name.empty() ? fmt::format("light {}", light.index) : name;
}

Color Coefficients::ambient() const {
  return phong.ambient * phong.ambient_color * point.base_color;
}
Color Coefficients::diffuse() const {
  return phong.diffuse * phong.diffuse_color * point.base_color;
}
Color Coefficients::specular() const { return phong.specular * phong.specular_color; }
Color Coefficients::reflection() const { return phong.reflection * phong.specular_color; }
Color Coefficients::transmission() const { return phong.transmission * phong.transmission_color; }

Coefficients coefficients_at(const shading::Scene& scene, const RayNote& ray,
                             const SurfaceNote& surface) {
  Coefficients result;
  result.point = shading::evaluate_material(scene, surface.point, -ray.ray.direction);
  result.phong = shading::equivalent_phong(result.point);
  result.equivalent = !result.point.material->phong.has_value();
  return result;
}

float distance_to(const RayNote& ray, const SurfaceNote& surface) {
  const bool is_first = &surface == ray.surfaces.data();
  return is_first ? surface.point.t
                  : dot(surface.point.position - ray.ray.origin, ray.ray.direction);
}

Vec3 direction_to_light(const LightNote& light, const geometry::SurfacePoint& point) {
  const auto position = light_position(light);
  return normalize(position ? *position - point.position : light.ray.direction);
}

std::optional<Vec3> light_position(const LightNote& light) {
  // The ray ends just before the light, but one of its direction's lengths leads there.
  if (std::isinf(light.ray.t_max)) return std::nullopt;
  return light.ray.origin + light.ray.direction;
}

bool is_blocked(const LightNote& light) { return light.transmittance == Color(0.0f); }

bool leaves_scene(const shading::Scene& scene, const RayNote& ray) {
  if (ray.surfaces.empty() || ray.backdrop) return true;
  return coefficients_at(scene, ray, ray.surfaces.back()).point.coverage < 1.0f;
}

std::string_view name_of(RayKind kind) {
  switch (kind) {
    case RayKind::reflection:
      return "reflection";
    case RayKind::refraction:
      return "refraction";
    case RayKind::camera:
      break;
  }
  return "camera";
}

const RayLook& look_of(RayKind kind) { return k_ray_looks[static_cast<std::size_t>(kind)]; }

const RayLook& look_of(const LightNote& light) {
  constexpr std::size_t k_shadow = 3;
  return k_ray_looks[k_shadow + (is_blocked(light) ? 1 : 0)];
}

}  // namespace lume::cli
