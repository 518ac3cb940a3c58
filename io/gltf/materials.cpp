// SPDX-License-Identifier: Apache-2.0
// The metallic-roughness material (glTF 2.0, section 3.9) and its extensions.
#include "io/gltf/materials.h"

#include "io/gltf/phong.h"

#include <fmt/format.h>

#include <optional>

namespace lume::io::gltf {
namespace {

using shading::Color;
using shading::Material;
using shading::TextureUse;

float to_float(double value) { return static_cast<float>(value); }

Color to_color(const std::vector<double>& numbers) {
  return {to_float(numbers[0]), to_float(numbers[1]), to_float(numbers[2])};
}

float factor(const JsonView& object, std::string_view key, double fallback,
             const Range& range = k_unit) {
  return to_float(object.number_or(key, fallback, range));
}

std::uint32_t texcoord_set(const JsonView& info, std::uint32_t fallback) {
  const std::uint64_t set = info.integer_or("texCoord", fallback);
  if (set > 15) {
    info.require("texCoord").fail(fmt::format("is {}, expected a set from 0 to 15", set));
  }
  return static_cast<std::uint32_t>(set);
}

/// The texture under `key`, if there is one.
TextureUse texture_use(const JsonView& object, std::string_view key, TextureTable& textures) {
  const std::optional<JsonView> info = object.find(key);
  if (!info) {
    return {};
  }
  TextureUse use;
  use.texture = textures.use(info->require("index").index(textures.gltf_size(), "textures"));
  use.texcoord = texcoord_set(*info, 0);
  if (const std::optional<JsonView> transform = info->extension("KHR_texture_transform")) {
    const std::vector<double> offset = transform->numbers_or("offset", {0, 0}, k_any);
    const std::vector<double> scale = transform->numbers_or("scale", {1, 1}, k_any);
    use.transform.offset = {to_float(offset[0]), to_float(offset[1])};
    use.transform.scale = {to_float(scale[0]), to_float(scale[1])};
    use.transform.rotation = factor(*transform, "rotation", 0, k_any);
    use.texcoord = texcoord_set(*transform, use.texcoord);
  }
  return use;
}

void read_metallic_roughness(const JsonView& json, Material& material, TextureTable& textures) {
  const std::optional<JsonView> pbr = json.find("pbrMetallicRoughness");
  if (!pbr) {
    return;
  }
  const std::vector<double> base = pbr->numbers_or("baseColorFactor", {1, 1, 1, 1}, k_unit);
  material.base_color = to_color(base);
  material.alpha = to_float(base[3]);
  material.base_color_texture = texture_use(*pbr, "baseColorTexture", textures);
  material.metallic = factor(*pbr, "metallicFactor", 1);
  material.roughness = factor(*pbr, "roughnessFactor", 1);
  material.metallic_roughness_texture = texture_use(*pbr, "metallicRoughnessTexture", textures);
}

void read_surface(const JsonView& json, Material& material, TextureTable& textures) {
  material.normal_texture = texture_use(json, "normalTexture", textures);
  if (const std::optional<JsonView> normal = json.find("normalTexture")) {
    material.normal_scale = factor(*normal, "scale", 1, k_any);
  }
  material.occlusion_texture = texture_use(json, "occlusionTexture", textures);
  if (const std::optional<JsonView> occlusion = json.find("occlusionTexture")) {
    material.occlusion_strength = factor(*occlusion, "strength", 1);
  }
  material.emission = to_color(json.numbers_or("emissiveFactor", {0, 0, 0}, k_unit));
  material.emission_texture = texture_use(json, "emissiveTexture", textures);
  material.double_sided = json.boolean_or("doubleSided", false);
}

void read_alpha(const JsonView& json, Material& material) {
  const std::string mode = json.text_or("alphaMode", "OPAQUE");
  if (mode == "MASK") {
    material.alpha_mode = shading::AlphaMode::mask;
  } else if (mode == "BLEND") {
    material.alpha_mode = shading::AlphaMode::blend;
  } else if (mode != "OPAQUE") {
    json.require("alphaMode").fail("expected OPAQUE, MASK or BLEND");
  }
  material.alpha_cutoff = factor(json, "alphaCutoff", 0.5, k_not_negative);
}

float read_ior(const JsonView& ior) {
  const double value = ior.number_or("ior", 1.5, k_not_negative);
  if (value > 0.0 && value < 1.0) {
    ior.require("ior").fail(fmt::format("is {:g}, expected 0 or at least 1", value));
  }
  return to_float(value);
}

void read_extensions(const JsonView& json, Material& material, TextureTable& textures,
                     Notes& notes) {
  if (const auto strength = json.extension("KHR_materials_emissive_strength")) {
    material.emission *= factor(*strength, "emissiveStrength", 1, k_not_negative);
  }
  material.unlit = json.extension("KHR_materials_unlit").has_value();
  if (const auto ior = json.extension("KHR_materials_ior")) {
    material.ior = read_ior(*ior);
  }
  if (const auto specular = json.extension("KHR_materials_specular")) {
    material.specular = factor(*specular, "specularFactor", 1);
    material.specular_texture = texture_use(*specular, "specularTexture", textures);
    material.specular_color =
        to_color(specular->numbers_or("specularColorFactor", {1, 1, 1}, k_not_negative));
    material.specular_color_texture = texture_use(*specular, "specularColorTexture", textures);
  }
  if (const auto transmission = json.extension("KHR_materials_transmission")) {
    material.transmission = factor(*transmission, "transmissionFactor", 0);
    material.transmission_texture = texture_use(*transmission, "transmissionTexture", textures);
  }
  if (const auto volume = json.extension("KHR_materials_volume")) {
    material.thickness = factor(*volume, "thicknessFactor", 0, k_not_negative);
    const double infinity = std::numeric_limits<double>::infinity();
    material.attenuation_distance = factor(*volume, "attenuationDistance", infinity, k_positive);
    material.attenuation_color =
        to_color(volume->numbers_or("attenuationColor", {1, 1, 1}, k_unit));
    if (volume->has("thicknessTexture")) {
      notes.add("material '" + material.name + "'", "the thickness texture is not read");
    }
  }
}

}  // namespace

std::vector<Material> read_materials(const JsonView& root, TextureTable& textures, Notes& notes) {
  std::vector<Material> materials;
  for (const JsonView& json : root.items("materials")) {
    Material material;
    material.name = json.text_or("name", fmt::format("material {}", materials.size()));
    read_metallic_roughness(json, material, textures);
    read_surface(json, material, textures);
    read_alpha(json, material);
    read_extensions(json, material, textures, notes);
    read_phong_material(json, material, notes);
    materials.push_back(std::move(material));
  }
  return materials;
}

}  // namespace lume::io::gltf
