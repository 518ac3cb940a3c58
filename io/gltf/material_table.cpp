// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/material_table.h"

#include <utility>

namespace lume::io::gltf {

std::uint32_t MaterialTable::number(std::optional<std::size_t> gltf_material) {
  if (gltf_material) {
    return static_cast<std::uint32_t>(*gltf_material);
  }
  if (!default_) {
    default_ = static_cast<std::uint32_t>(materials_.size());
    materials_.emplace_back().name = "default";
  }
  return *default_;
}

std::uint32_t MaterialTable::double_sided(std::uint32_t material) {
  if (materials_[material].double_sided) {
    return material;
  }
  const auto [it, is_new] =
      double_sided_.try_emplace(material, static_cast<std::uint32_t>(materials_.size()));
  if (is_new) {
    shading::Material copy = materials_[material];
    copy.name += " (both sides)";
    copy.double_sided = true;
    materials_.push_back(std::move(copy));
  }
  return it->second;
}

std::optional<std::uint32_t> MaterialTable::tangent_set(std::uint32_t material) const {
  const shading::TextureUse& texture = materials_[material].normal_texture;
  const shading::TextureTransform& transform = texture.transform;
  const bool keeps_axes =
      transform.rotation == 0.0f && transform.scale.x > 0.0f && transform.scale.y > 0.0f;
  return texture && keeps_axes ? std::optional(texture.texcoord) : std::nullopt;
}

bool MaterialTable::may_have_holes(std::uint32_t material, bool has_vertex_colors) const {
  const shading::Material& m = materials_[material];
  return m.alpha_mode == shading::AlphaMode::mask &&
         (m.alpha < m.alpha_cutoff || m.base_color_texture || has_vertex_colors);
}

}  // namespace lume::io::gltf
