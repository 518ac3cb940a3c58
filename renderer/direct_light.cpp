// SPDX-License-Identifier: Apache-2.0
#include "renderer/direct_light.h"

#include "renderer/ray_tree.h"
#include "renderer/shadow.h"
#include "shading/material_point.h"
#include "shading/warp.h"

#include <algorithm>
#include <cmath>

namespace lume::renderer {
namespace {

enum Dimension : std::uint32_t { k_environment, k_emitter_choice, k_emitter_position };

/// Adds up the light of one surface.
class Gatherer {
 public:
  Gatherer(const PreparedScene& prepared, const ShadedPoint& point, bool shadows, Ledger& ledger)
      : prepared_(prepared), point_(point), shadows_(shadows), ledger_(ledger) {}

  void add_environment(const Sampler& sampler);
  void add_emitter(const Sampler& sampler);
  void add_punctual(const shading::PunctualLight& light);

  [[nodiscard]] const DirectLight& sum() const { return sum_; }

 private:
  /// Light that arrives along a shadow ray, if nothing is in the way.
  struct Arrival {
    Vec3 to_light{0.0f};      ///< unit
    Color illuminance{0.0f};  ///< on a surface that faces it (lx); its mean, where a point is drawn
    float ambient_occlusion = 1.0f;  ///< of the diffuse part
    /// Density of the direction where reflection rays can meet the light too; 0: they cannot.
    float pdf = 0.0f;
  };

  void add(const Arrival& arrival, const geometry::Ray& ray, LightNote::Kind kind,
           std::uint32_t index = 0, const geometry::Hit& emitter = {});

  const PreparedScene& prepared_;
  const ShadedPoint& point_;
  bool shadows_;
  Ledger& ledger_;
  DirectLight sum_;
};

void Gatherer::add(const Arrival& arrival, const geometry::Ray& ray, LightNote::Kind kind,
                   std::uint32_t index, const geometry::Hit& emitter) {
  if (arrival.illuminance == Color(0.0f) || !point_.is_above(arrival.to_light)) return;
  const Color diffuse =
      arrival.illuminance * arrival.ambient_occlusion * point_.bsdf.eval_diffuse(arrival.to_light);
  Color specular = arrival.illuminance * point_.bsdf.eval_specular(arrival.to_light);
  if (diffuse + specular == Color(0.0f)) return;

  Transmittance passes;
  if (shadows_) passes = trace_shadow(prepared_, ray, ledger_.counts);
  if (point_.reflects && arrival.pdf > 0.0f) {
    // A mirror's highlight is black already, and one that is a term of its own has no density.
    const float reflection_pdf = point_.bsdf.reflection_pdf(arrival.to_light);
    if (reflection_pdf > 0.0f) {
      specular *= passes.through_transmissive ? 0.0f : balance(arrival.pdf, reflection_pdf);
    }
  }
  const Color arriving_diffuse = passes.color * diffuse;
  const Color arriving_specular = passes.color * specular;
  sum_.diffuse += arriving_diffuse;
  sum_.specular += arriving_specular;
  sum_.shadow += (diffuse - arriving_diffuse) + (specular - arriving_specular);
  if (ledger_.tree != nullptr) {
    ledger_.tree->lights.push_back({kind, index, emitter, ray, arrival.illuminance / geometry::k_pi,
                                    passes.color, arriving_diffuse, arriving_specular});
  }
}

void Gatherer::add_punctual(const shading::PunctualLight& light) {
  const auto incidence = shading::illuminate(light, point_.surface.position);
  const geometry::Ray ray = std::isinf(incidence.distance)
                                ? shadow_ray_along(point_.surface, incidence.to_light)
                                : shadow_ray(point_.surface, light.position);
  const auto index = static_cast<std::uint32_t>(&light - prepared_.scene().lights.data());
  add({incidence.to_light, incidence.illuminance}, ray, LightNote::Kind::punctual, index);
}

void Gatherer::add_environment(const Sampler& sampler) {
  const auto& environment = prepared_.scene().environment;
  if (!environment) return;
  const EnvironmentAim aim = environment_aim(point_.material, point_.bsdf);
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
  const float pdf = environment_pdf(prepared_, aim, direction);
  if (!(pdf > 0.0f)) return;
  add({direction, environment->radiance(direction) / pdf, point_.material.occlusion, pdf},
      shadow_ray_along(point_.surface, direction), LightNote::Kind::environment);
}

void Gatherer::add_emitter(const Sampler& sampler) {
  if (prepared_.emitters().empty()) return;
  const Vec3& from = point_.surface.position;
  const EmitterSample sample = prepared_.emitters().sample(
      sampler.get_1d(k_emitter_choice), sampler.get_2d(k_emitter_position), from);
  if (!(sample.pdf > 0.0f)) return;
  const Vec3 to_light = normalize(sample.position - from);
  geometry::SurfacePoint met;  // only what evaluate_emission looks at
  met.hit = sample.hit;
  met.geometry = &prepared_.scene().world.geometry(sample.hit);
  met.uv = sample.uv;
  met.front_facing = dot(sample.normal, to_light) < 0.0f;
  const Color radiance = shading::evaluate_emission(prepared_.scene(), met);
  add({to_light, radiance / sample.pdf, 1.0f, sample.pdf},
      shadow_ray(point_.surface, sample.position), LightNote::Kind::emitter, 0, sample.hit);
}

}  // namespace

DirectLight direct_light(const PreparedScene& prepared, const ShadedPoint& point, bool shadows,
                         const Sampler& sampler, Ledger& ledger) {
  if (!point.bsdf.scatters()) return {};
  Gatherer gatherer(prepared, point, shadows, ledger);
  gatherer.add_environment(sampler);
  gatherer.add_emitter(sampler);
  for (const shading::PunctualLight& light : prepared.scene().lights) gatherer.add_punctual(light);
  return gatherer.sum();
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

}  // namespace lume::renderer
