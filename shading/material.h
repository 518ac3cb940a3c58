// SPDX-License-Identifier: Apache-2.0
// The glTF 2.0 metallic-roughness material with the extensions Lume honours, and the course's
// coefficients in its place where a file gives those. Factors and textures multiply, as the
// specification says; defaults are the specification's.
#pragma once

#include "shading/color.h"
#include "shading/texture.h"

#include <limits>
#include <optional>
#include <string>

namespace lume::shading {

enum class AlphaMode { opaque, mask, blend };

/// The coefficients k and colours O of the course's recursive model (extension
/// LUME_materials_phong; phong_bsdf.h has the formula). Both are without unit, 0 to 1.
struct Phong {
  float ambient = 1.0f;        ///< k_a
  Color ambient_color{1.0f};   ///< O_a is this times the base colour
  float diffuse = 1.0f;        ///< k_d
  Color diffuse_color{1.0f};   ///< O_d is this times the base colour
  float specular = 0.0f;       ///< k_s, of highlights
  Color specular_color{1.0f};  ///< O_s
  float shininess = 50.0f;     ///< n, the exponent of highlights
  float reflection = 0.0f;     ///< k_r, of reflected rays; in the course's formula the same as k_s
  /// Exponent of the lobe around the mirror direction in which reflected rays run; infinite for a
  /// mirror.
  float glossiness = std::numeric_limits<float>::infinity();
  float transmission = 0.0f;       ///< k_t
  Color transmission_color{1.0f};  ///< O_t
  /// Off: k_r and k_t are constants, as in the course. On: they are multiplied by the reflectance
  /// and transmittance of the boundary, after Fresnel.
  bool fresnel = false;
};

struct Material {
  std::string name;

  Color base_color{1.0f};
  float alpha = 1.0f;
  TextureUse base_color_texture;  ///< sRGB, alpha linear
  float metallic = 1.0f;
  float roughness = 1.0f;
  TextureUse metallic_roughness_texture;  ///< G roughness, B metallic
  TextureUse normal_texture;
  float normal_scale = 1.0f;
  TextureUse occlusion_texture;  ///< R; darkens ambient light only
  float occlusion_strength = 1.0f;
  Color emission{0.0f};         ///< emissiveFactor * emissiveStrength, nits
  TextureUse emission_texture;  ///< sRGB

  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;  ///< KHR_materials_unlit: base colour shown as it is

  /// KHR_materials_specular: strength of the dielectric reflection, and its tint at normal
  /// incidence.
  float specular = 1.0f;
  TextureUse specular_texture;        ///< A
  Color specular_color{1.0f};         ///< may exceed 1
  TextureUse specular_color_texture;  ///< sRGB
  float ior = 1.5f;           ///< KHR_materials_ior; 0 means: reflects all, as the extension says
  float transmission = 0.0f;  ///< KHR_materials_transmission
  TextureUse transmission_texture;  ///< R
  /// KHR_materials_volume: a thickness above 0 makes the surface the boundary of a solid, whose
  /// rays are refracted and absorbed; at 0 it is an infinitely thin sheet.
  float thickness = 0.0f;
  float attenuation_distance = std::numeric_limits<float>::infinity();  ///< metres, world
  Color attenuation_color{1.0f};  ///< what is left of white light after attenuation_distance

  /// Takes the place of metallic, roughness and transmission.
  std::optional<Phong> phong;

  /// A closed surface, in which rays are refracted and absorbed. What the course calls transparent
  /// always is one.
  [[nodiscard]] bool is_solid() const {
    return phong ? phong->transmission > 0.0f : thickness > 0.0f && transmission > 0.0f;
  }
  /// Back faces are absent (glTF 2.0, section 3.9.5, back-face culling): whatever arrives from
  /// behind goes on as if there were nothing. Not for solids: a ray inside must find its way out.
  [[nodiscard]] bool is_one_way() const { return !double_sided && !is_solid(); }
  /// Light passes through some points of the surface.
  [[nodiscard]] bool is_see_through() const {
    const bool transmits = phong ? phong->transmission > 0.0f : transmission > 0.0f;
    return alpha_mode == AlphaMode::blend || transmits;
  }
  [[nodiscard]] bool is_textured() const {
    return base_color_texture || metallic_roughness_texture || normal_texture ||
           occlusion_texture || emission_texture || transmission_texture || specular_texture ||
           specular_color_texture;
  }
  [[nodiscard]] bool is_emissive() const { return !unlit && max_component(emission) > 0.0f; }
};

}  // namespace lume::shading
