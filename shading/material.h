// SPDX-License-Identifier: Apache-2.0
// The glTF 2.0 metallic-roughness material with the extensions Lume honours. Factors and textures
// multiply, as the specification says; defaults are the specification's.
#pragma once

#include "shading/color.h"
#include "shading/texture.h"

#include <limits>
#include <string>

namespace lume::shading {

enum class AlphaMode { opaque, mask, blend };

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

  float ior = 1.5f;           ///< KHR_materials_ior; 0 means: reflects all, as the extension says
  float transmission = 0.0f;  ///< KHR_materials_transmission
  TextureUse transmission_texture;  ///< R
  /// KHR_materials_volume: a thickness above 0 makes the surface the boundary of a solid, whose
  /// rays are refracted and absorbed; at 0 it is an infinitely thin sheet.
  float thickness = 0.0f;
  float attenuation_distance = std::numeric_limits<float>::infinity();  ///< metres, world
  Color attenuation_color{1.0f};  ///< what is left of white light after attenuation_distance

  [[nodiscard]] bool is_solid() const { return thickness > 0.0f && transmission > 0.0f; }
  /// Back faces are absent (glTF 2.0, section 3.9.5, back-face culling): whatever arrives from
  /// behind goes on as if there were nothing. Not for solids: a ray inside must find its way out.
  [[nodiscard]] bool is_one_way() const { return !double_sided && !is_solid(); }
  /// Light passes through some points of the surface.
  [[nodiscard]] bool is_see_through() const {
    return alpha_mode == AlphaMode::blend || transmission > 0.0f;
  }
  [[nodiscard]] bool is_emissive() const { return !unlit && max_component(emission) > 0.0f; }
};

}  // namespace lume::shading
