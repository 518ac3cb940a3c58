// SPDX-License-Identifier: Apache-2.0
#include "shading/gltf_bsdf.h"

#include "shading/fresnel.h"
#include "shading/microfacet.h"

#include <algorithm>

namespace lume::shading {
namespace {

/// KHR_materials_ior: an index of 0 stands for infinity, a dielectric that reflects everything.
float dielectric_reflectance(float ior) { return ior == 0.0f ? 1.0f : normal_reflectance(ior); }

/// What a dielectric layer reflects at normal and at grazing incidence.
struct Layer {
  Color f0{0.04f};
  float f90 = 1.0f;
};

/// KHR_materials_specular; without it the layer of the index of refraction alone, to the bit.
Layer dielectric_layer(const MaterialPoint& point) {
  const float f0 = dielectric_reflectance(point.material->ior);
  return {min(f0 * point.specular_color, Color(1.0f)) * point.specular,
          grazing_reflectance(f0) * point.specular};
}

Vec3 mirrored_at_surface(const Vec3& v) { return {v.x, v.y, -v.z}; }

}  // namespace

GltfBsdf::GltfBsdf(const MaterialPoint& point, const Vec3& to_viewer, bool inside)
    : frame_(geometry::make_frame(point.normal)),
      to_viewer_(frame_.to_local(to_viewer)),
      alpha_(point.roughness * point.roughness),
      solid_(point.material->is_solid()) {
  const float dielectric = 1.0f - point.metallic;
  diffuse_ = point.base_color * (dielectric * (1.0f - point.transmission));
  transmission_ = point.base_color * (dielectric * point.transmission);
  const Layer layer = dielectric_layer(point);
  layer_f0_ = max_component(layer.f0);
  layer_f90_ = layer.f90;
  inside_tint_ = min(point.specular_color, Color(1.0f)) * point.specular;
  f0_ = layer.f0 * dielectric + point.base_color * point.metallic;
  f90_ = Color(layer_f90_ * dielectric + point.metallic);
  const float ior = std::max(point.material->ior, 1.0f);
  eta_ = inside ? ior : 1.0f / ior;
}

Color GltfBsdf::fresnel(float cosine) const {
  // Inside a solid Schlick's approximation knows nothing of total internal reflection.
  if (solid_ && eta_ > 1.0f) {
    const float reflectance = fresnel_dielectric(cosine, eta_);
    return reflectance < 1.0f ? reflectance * inside_tint_ : Color(1.0f);
  }
  return fresnel_schlick(f0_, f90_, cosine);
}

Vec3 GltfBsdf::sample_half_vector(Vec2 random) const {
  if (is_mirror(alpha_)) return {0.0f, 0.0f, 1.0f};
  return sample_visible_normal(to_viewer_, alpha_, random);
}

Color GltfBsdf::ambient() const {
  if (layer_f0_ >= 1.0f) return Color(0.0f);
  // The way in averages to 1 - F_average and cancels.
  return diffuse_ * (1.0f - fresnel_schlick(layer_f0_, layer_f90_, to_viewer_.z));
}

Color GltfBsdf::eval_diffuse(const Vec3& to_light) const {
  const Vec3 wi = frame_.to_local(to_light);
  if (wi.z <= 0.0f || layer_f0_ >= 1.0f) return Color(0.0f);
  const float in = 1.0f - fresnel_schlick(layer_f0_, layer_f90_, wi.z);
  const float out = 1.0f - fresnel_schlick(layer_f0_, layer_f90_, to_viewer_.z);
  const float layer = in * out / (1.0f - fresnel_schlick_average(layer_f0_, layer_f90_));
  return diffuse_ * (layer * wi.z / geometry::k_pi);
}

Color GltfBsdf::eval_specular(const Vec3& to_light) const {
  const Vec3 wi = frame_.to_local(to_light);
  if (is_mirror(alpha_) || wi.z <= 0.0f) return Color(0.0f);
  const Vec3 h = normalize(wi + to_viewer_);
  // f cos = F D G2 / (4 cos_o cos_i) * cos_i
  return fresnel(dot(h, wi)) *
         (ggx_distribution(h, alpha_) * smith_masking_shadowing(wi, to_viewer_, alpha_) /
          (4.0f * to_viewer_.z));
}

float GltfBsdf::reflection_pdf(const Vec3& to_light) const {
  const Vec3 wi = frame_.to_local(to_light);
  if (is_mirror(alpha_) || wi.z <= 0.0f) return 0.0f;
  const Vec3 h = normalize(wi + to_viewer_);
  return visible_normal_pdf(to_viewer_, h, alpha_) / (4.0f * dot(to_viewer_, h));
}

std::optional<LobeSample> GltfBsdf::sample_reflection(Vec2 random) const {
  const Vec3 h = sample_half_vector(random);
  const Vec3 wi = reflect(to_viewer_, h);
  if (wi.z <= 0.0f) return std::nullopt;
  const Color f = fresnel(dot(to_viewer_, h));
  const Vec3 direction = frame_.to_world(wi);
  if (is_mirror(alpha_)) return LobeSample{direction, f, 0.0f};
  // F D G2 / (4 cos_o) over the density D G1 / (4 cos_o) leaves F G2 / G1 (Heitz 2018, eq. 19).
  const float shadowing =
      smith_masking_shadowing(wi, to_viewer_, alpha_) / smith_masking(to_viewer_, alpha_);
  const float pdf = visible_normal_pdf(to_viewer_, h, alpha_) / (4.0f * dot(to_viewer_, h));
  return LobeSample{direction, f * shadowing, pdf};
}

std::optional<LobeSample> GltfBsdf::sample_transmission(Vec2 random) const {
  if (max_component(transmission_) <= 0.0f) return std::nullopt;
  const Vec3 h = sample_half_vector(random);
  std::optional<Vec3> wi;
  if (solid_) {
    wi = refract(to_viewer_, h, eta_);
  } else {
    wi = mirrored_at_surface(reflect(to_viewer_, h));
  }
  if (!wi || wi->z >= 0.0f) return std::nullopt;
  const Color through = transmission_ * (Color(1.0f) - fresnel(dot(to_viewer_, h)));
  const float shadowing =
      is_mirror(alpha_) ? 1.0f
                        : smith_masking_shadowing(mirrored_at_surface(*wi), to_viewer_, alpha_) /
                              smith_masking(to_viewer_, alpha_);
  return LobeSample{frame_.to_world(*wi), through * shadowing, 0.0f};
}

Color GltfBsdf::reflection_color() const { return fresnel(to_viewer_.z); }

Color gltf_straight_transmittance(const MaterialPoint& point, float cosine) {
  const Layer layer = dielectric_layer(point);
  const Color reflected = fresnel_schlick(layer.f0, Color(layer.f90), cosine);
  return point.base_color * (Color(1.0f) - reflected) *
         ((1.0f - point.metallic) * point.transmission);
}

}  // namespace lume::shading
