// SPDX-License-Identifier: Apache-2.0
#include "renderer/direct_light.h"

#include "renderer/shadow.h"
#include "shading/warp.h"

#include <algorithm>
#include <cmath>

namespace lume::renderer {
namespace {

using shading::Color;

enum Dimension : std::uint32_t { k_environment, k_emitter_choice, k_emitter_position };

/// What the surface does with light from one direction.
struct Response {
  Color diffuse{0.0f};   ///< BRDF * cosine
  Color specular{0.0f};  ///< BRDF * cosine

  [[nodiscard]] bool is_black() const { return diffuse + specular == Color(0.0f); }
};

Response respond(const ShadedPoint& point, const Vec3& to_light) {
  // A normal map must not let light in from behind the actual surface.
  const float side = point.surface.front_facing ? 1.0f : -1.0f;
  if (side * dot(point.surface.geometric_normal, to_light) <= 0.0f) return {};
  return {point.bsdf.eval_diffuse(to_light), point.bsdf.eval_specular(to_light)};
}

Color punctual_light(const PreparedScene& prepared, const ShadedPoint& point,
                     const shading::PunctualLight& light, RayCounts& counts) {
  const auto incidence = shading::illuminate(light, point.surface.position);
  if (incidence.illuminance == Color(0.0f)) return Color(0.0f);
  const Response response = respond(point, incidence.to_light);
  if (response.is_black()) return Color(0.0f);
  const geometry::Ray ray = std::isinf(incidence.distance)
                                ? shadow_ray_along(point.surface, incidence.to_light)
                                : shadow_ray(point.surface, light.position);
  return incidence.illuminance * trace_shadow(prepared, ray, counts).color *
         (response.diffuse + response.specular);
}

/// Light from something that reflection rays can meet too: `radiance` from `to_light`, where shadow
/// rays are aimed with density `pdf`.
Color shared_light(const PreparedScene& prepared, const ShadedPoint& point,
                   const geometry::Ray& ray, const Vec3& to_light, const Color& radiance, float pdf,
                   float ambient_occlusion, RayCounts& counts) {
  if (!(pdf > 0.0f) || radiance == Color(0.0f)) return Color(0.0f);
  Response response = respond(point, to_light);
  response.diffuse *= ambient_occlusion;
  if (response.is_black()) return Color(0.0f);
  const Transmittance transmittance = trace_shadow(prepared, ray, counts);
  if (point.reflects) {
    const bool left_to_reflection = transmittance.through_transmissive;
    response.specular *=
        left_to_reflection ? 0.0f : balance(pdf, point.bsdf.reflection_pdf(to_light));
  }
  return radiance * transmittance.color * (response.diffuse + response.specular) / pdf;
}

Color environment_light(const PreparedScene& prepared, const ShadedPoint& point,
                        const Sampler& sampler, RayCounts& counts) {
  const auto& environment = prepared.scene().environment;
  if (!environment) return Color(0.0f);
  const EnvironmentAim aim = environment_aim(point.material, point.bsdf);
  // The first number chooses the strategy and, stretched again, a direction, so that the samples of
  // either strategy are as well spread as all of them.
  Vec2 random = sampler.get_2d(k_environment);
  const bool by_cosine = random.x < aim.cosine_share;
  random.x = by_cosine ? random.x / aim.cosine_share
                       : (random.x - aim.cosine_share) / (1.0f - aim.cosine_share);
  const Vec3 direction =
      by_cosine
          ? geometry::make_frame(aim.normal).to_world(shading::sample_cosine_hemisphere(random))
          : environment->sample(random).direction;
  return shared_light(prepared, point, shadow_ray_along(point.surface, direction), direction,
                      environment->radiance(direction), environment_pdf(prepared, aim, direction),
                      point.material.occlusion, counts);
}

Color emitter_light(const PreparedScene& prepared, const ShadedPoint& point, const Sampler& sampler,
                    RayCounts& counts) {
  if (prepared.emitters().empty()) return Color(0.0f);
  const EmitterSample sample = prepared.emitters().sample(sampler.get_1d(k_emitter_choice),
                                                          sampler.get_2d(k_emitter_position));
  const Vec3 offset = sample.position - point.surface.position;
  const float distance = length(offset);
  if (!(distance > 0.0f)) return Color(0.0f);
  const Vec3 to_light = offset / distance;
  geometry::SurfacePoint met;  // only what evaluate_emission looks at
  met.hit = sample.hit;
  met.geometry = &prepared.scene().world.geometry(sample.hit);
  met.uv = sample.uv;
  met.front_facing = dot(sample.normal, to_light) < 0.0f;
  const float cosine = std::abs(dot(sample.normal, to_light));
  if (!(cosine > 0.0f)) return Color(0.0f);
  const float pdf = sample.area_pdf * distance * distance / cosine;
  return shared_light(prepared, point, shadow_ray(point.surface, sample.position), to_light,
                      shading::evaluate_emission(prepared.scene(), met), pdf, 1.0f, counts);
}

}  // namespace

Color direct_light(const PreparedScene& prepared, const ShadedPoint& point, const Sampler& sampler,
                   RayCounts& counts) {
  Color sum = environment_light(prepared, point, sampler, counts) +
              emitter_light(prepared, point, sampler, counts);
  for (const shading::PunctualLight& light : prepared.scene().lights) {
    sum += punctual_light(prepared, point, light, counts);
  }
  return sum;
}

EnvironmentAim environment_aim(const shading::MaterialPoint& material, const shading::Bsdf& bsdf) {
  return {material.normal, bsdf.has_diffuse() ? 0.5f : 0.0f};
}

float environment_pdf(const PreparedScene& prepared, const EnvironmentAim& aim,
                      const Vec3& direction) {
  const float by_radiance = prepared.scene().environment->pdf(direction);
  const float by_cosine = std::max(0.0f, dot(aim.normal, direction)) / geometry::k_pi;
  return by_radiance + aim.cosine_share * (by_cosine - by_radiance);
}

float emitter_pdf(const PreparedScene& prepared, const geometry::SurfacePoint& met, float distance,
                  const Vec3& direction) {
  const float cosine = std::abs(dot(met.geometric_normal, direction));
  if (!(cosine > 0.0f)) return 0.0f;
  return prepared.emitters().area_pdf(met.hit) * distance * distance / cosine;
}

}  // namespace lume::renderer
