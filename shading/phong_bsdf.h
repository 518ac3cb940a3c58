// SPDX-License-Identifier: Apache-2.0
// The course's recursive illumination model, after Phong 1975 ("Illumination for Computer Generated
// Pictures") and Whitted 1980 ("An Improved Illumination Model for Shaded Display"):
//   I = L_a k_a O_a + sum over lights f_att L_p (k_d O_d (n.l) + k_s O_s (r.v)^n)
//     + k_r O_s I_reflected + k_t O_t I_transmitted,
// where the course writes k_s for k_r too. L_p is the radiance of a white matte surface that faces
// the light, the illuminance over pi; so what is called BRDF below is the bracket over pi.
// The model is older than the conservation of energy in computer graphics: the highlight has no
// (n.l), and coefficients may add up to more than 1. Directions are unit vectors in the scene's
// frame that point away from the surface.
#pragma once

#include "shading/color.h"
#include "shading/lobe_sample.h"
#include "shading/material_point.h"

#include <cmath>
#include <optional>

namespace lume::shading {

class PhongBsdf {
 public:
  /// `inside`: the viewer is inside the solid that the surface bounds. The material must have the
  /// course's coefficients.
  PhongBsdf(const MaterialPoint& point, const Vec3& to_viewer, bool inside);

  /// k_a O_a.
  [[nodiscard]] Color ambient() const;
  [[nodiscard]] bool scatters() const { return has_diffuse() || phong_->specular > 0.0f; }
  /// k_d O_d (n.l) / pi; 0 below the surface.
  [[nodiscard]] Color eval_diffuse(const Vec3& to_light) const;
  /// k_s O_s (r.v)^n / pi; 0 for light from below the surface.
  [[nodiscard]] Color eval_specular(const Vec3& to_light) const;

  [[nodiscard]] bool reflects_sharply() const { return std::isinf(phong_->glossiness); }
  /// The mirror direction r = 2 (n.v) n - v, or where there is a glossiness g, one around it with
  /// density (g + 1) / (2 pi) cos^g, none when that goes into the surface.
  [[nodiscard]] std::optional<LobeSample> sample_reflection(Vec2 random) const;
  /// The direction after Snell's law; none beyond the critical angle, where Whitted takes the
  /// transmitted light for 0.
  [[nodiscard]] std::optional<LobeSample> sample_transmission() const;

  [[nodiscard]] bool has_diffuse() const { return phong_->diffuse > 0.0f; }
  /// k_r O_s, with Fresnel if it is on.
  [[nodiscard]] Color reflection_color() const;
  /// k_t O_t, with Fresnel if it is on.
  [[nodiscard]] Color transmission_color() const;

 private:
  const Phong* phong_;
  Color base_color_;
  Vec3 normal_;
  Vec3 to_viewer_;
  Vec3 mirrored_;             ///< the viewer, at the normal: (r.v) is (l.mirrored)
  float eta_;                 ///< index of refraction on the viewer's side over the other side
  float reflectance_ = 1.0f;  ///< of the boundary; 1 where Fresnel is off
  float transmittance_ = 1.0f;
};

/// What a shadow ray keeps that crosses the surface in a straight line: k_t O_t, with Fresnel if it
/// is on. `cosine` is that of the angle with the normal.
[[nodiscard]] Color phong_straight_transmittance(const MaterialPoint& point, float cosine);

}  // namespace lume::shading
