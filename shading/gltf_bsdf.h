// SPDX-License-Identifier: Apache-2.0
// The glTF metallic-roughness BSDF (glTF 2.0, appendix B, and KHR_materials_transmission):
//   f = mix(dielectric, metal, metallic),
//   dielectric = mix(mix(diffuse, through, transmission), specular, F(ior)),
//   metal = specular * F(base colour),
// a Lambertian base under a GGX layer that reflects and, where the surface is transmissive, lets
// through. Where the appendix weighs the base by 1 - F(v.h), which at grazing angles adds up to
// more light than arrives, the base here gets what the layer leaves on the way in and on the way
// out,
//   (1 - F(n.l)) (1 - F(n.v)) / (1 - F_average),
// which is reciprocal and conserves energy (Shirley, Smits, Hu, Lafortune 1997, "A Practitioners'
// Assessment of Light Reflection Models"; Kelemen and Szirmay-Kalos 2001).
// KHR_materials_specular sets what the layer reflects to
//   F0 = min(F0(ior) * specular colour, 1) * specular,  F90 = specular;
// a tinted layer takes from the base what its strongest colour reflects, as the extension says.
// Directions are unit vectors in the scene's frame that point away from the surface.
#pragma once

#include "geometry/math.h"
#include "shading/color.h"
#include "shading/lobe_sample.h"
#include "shading/material_point.h"

#include <optional>

namespace lume::shading {

/// Below a width of 0.001 (roughness 0.03) the lobe is narrower than half a degree, and in float
/// its density is more noise than number: the surface is a mirror.
[[nodiscard]] inline bool is_mirror(float alpha) { return alpha < 1e-3f; }

class GltfBsdf {
 public:
  /// `inside`: the viewer is inside the solid that the surface bounds.
  GltfBsdf(const MaterialPoint& point, const Vec3& to_viewer, bool inside);

  /// What the diffuse part makes of light that comes in evenly from everywhere: the integral of
  /// eval_diffuse over the hemisphere.
  [[nodiscard]] Color ambient() const;
  [[nodiscard]] bool scatters() const { return has_diffuse() || !reflects_sharply(); }
  /// Diffuse BRDF times the cosine (1/sr); 0 below the surface.
  [[nodiscard]] Color eval_diffuse(const Vec3& to_light) const;
  /// Specular BRDF times the cosine (1/sr); 0 for a mirror and below the surface.
  [[nodiscard]] Color eval_specular(const Vec3& to_light) const;
  /// The density with which sample_reflection() returns a direction; 0 for a mirror.
  [[nodiscard]] float reflection_pdf(const Vec3& to_light) const;

  /// Both lobes are a single direction.
  [[nodiscard]] bool reflects_sharply() const { return is_mirror(alpha_); }
  /// Draws from the specular layer; none when the direction drawn goes into the surface.
  [[nodiscard]] std::optional<LobeSample> sample_reflection(Vec2 random) const;
  /// Draws from the transmitted light: refracted at a solid, straight on through a thin sheet (both
  /// spread by roughness). None where nothing is transmitted.
  [[nodiscard]] std::optional<LobeSample> sample_transmission(Vec2 random) const;

  [[nodiscard]] bool has_diffuse() const { return max_component(diffuse_) > 0.0f; }
  /// What the specular layer reflects at the macroscopic normal, to decide whether a reflection ray
  /// is worth tracing.
  [[nodiscard]] Color reflection_color() const;
  [[nodiscard]] const Color& transmission_color() const { return transmission_; }

 private:
  [[nodiscard]] Color fresnel(float cosine) const;
  [[nodiscard]] Vec3 sample_half_vector(Vec2 random) const;

  geometry::Frame frame_;
  Vec3 to_viewer_{0.0f};  ///< local
  Color diffuse_{0.0f};   ///< albedo under the specular layer
  /// Reflectance of the dielectric layer over it at normal incidence, of its strongest colour.
  float layer_f0_ = 0.04f;
  float layer_f90_ = 1.0f;  ///< and at grazing incidence
  Color transmission_{0.0f};
  Color f0_{0.0f};  ///< of dielectric and metal mixed
  Color f90_{1.0f};
  Color inside_tint_{1.0f};  ///< of what the boundary reflects inside, short of total reflection
  float alpha_ = 1.0f;
  float eta_ = 1.0f;  ///< index of refraction on the viewer's side over the other side
  bool solid_ = false;
};

/// Part of the light that goes straight through a surface at this angle: what a shadow ray keeps.
/// `cosine` is that of the angle with the normal.
[[nodiscard]] Color gltf_straight_transmittance(const MaterialPoint& point, float cosine);

}  // namespace lume::shading
