// SPDX-License-Identifier: Apache-2.0
#include "shading/phong_bsdf.h"

#include "shading/fresnel.h"
#include "shading/warp.h"

#include <algorithm>
#include <cmath>

namespace lume::shading {

PhongBsdf::PhongBsdf(const MaterialPoint& point, const Vec3& to_viewer, bool inside)
    : phong_(&*point.material->phong),
      base_color_(point.base_color),
      normal_(point.normal),
      to_viewer_(to_viewer),
      mirrored_(reflect(to_viewer, point.normal)),
      eta_(inside ? point.material->ior : 1.0f / point.material->ior) {
  if (phong_->fresnel) {
    reflectance_ = fresnel_dielectric(dot(normal_, to_viewer_), eta_);
    transmittance_ = 1.0f - reflectance_;
  }
}

Color PhongBsdf::ambient() const { return phong_->ambient * phong_->ambient_color * base_color_; }

Color PhongBsdf::eval_diffuse(const Vec3& to_light) const {
  const float cosine = std::max(0.0f, dot(normal_, to_light));
  return phong_->diffuse * phong_->diffuse_color * base_color_ * (cosine / geometry::k_pi);
}

Color PhongBsdf::eval_specular(const Vec3& to_light) const {
  if (phong_->specular <= 0.0f || dot(normal_, to_light) <= 0.0f) return Color(0.0f);
  const float cosine = std::max(0.0f, dot(mirrored_, to_light));
  return phong_->specular * phong_->specular_color *
         (std::pow(cosine, phong_->shininess) / geometry::k_pi);
}

Color PhongBsdf::reflection_color() const {
  return phong_->reflection * reflectance_ * phong_->specular_color;
}

Color PhongBsdf::transmission_color() const {
  return phong_->transmission * transmittance_ * phong_->transmission_color;
}

std::optional<LobeSample> PhongBsdf::sample_reflection(Vec2 random) const {
  if (reflects_sharply()) return LobeSample{mirrored_, reflection_color(), 0.0f};
  const Vec3 local = sample_cosine_power(random, phong_->glossiness);
  const Vec3 direction = geometry::make_frame(mirrored_).to_world(local);
  if (dot(normal_, direction) <= 0.0f) return std::nullopt;
  return LobeSample{direction, reflection_color(), 0.0f};
}

std::optional<LobeSample> PhongBsdf::sample_transmission() const {
  const auto direction = refract(to_viewer_, normal_, eta_);
  if (!direction) return std::nullopt;
  return LobeSample{*direction, transmission_color(), 0.0f};
}

Color phong_straight_transmittance(const MaterialPoint& point, float cosine) {
  const Phong& phong = *point.material->phong;
  const float boundary =
      phong.fresnel ? 1.0f - fresnel_dielectric(cosine, 1.0f / point.material->ior) : 1.0f;
  return phong.transmission * boundary * phong.transmission_color;
}

}  // namespace lume::shading
