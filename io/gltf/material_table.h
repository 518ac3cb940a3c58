// SPDX-License-Identifier: Apache-2.0
// The numbers of materials that surfaces point to, and the materials that the file does not have:
// glTF's default one, and double-sided copies.
#pragma once

#include "shading/material.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace lume::io::gltf {

class MaterialTable {
 public:
  /// `materials` are those of the file; others are appended when they are asked for first.
  explicit MaterialTable(std::vector<shading::Material>& materials)
      : materials_(materials), gltf_size_(materials.size()) {}

  /// How many the file has.
  [[nodiscard]] std::size_t gltf_size() const { return gltf_size_; }
  /// Of a material of the file; the default one for a surface that has none.
  [[nodiscard]] std::uint32_t number(std::optional<std::size_t> gltf_material);
  /// Of a copy that shows both of its sides; itself if it does so already.
  [[nodiscard]] std::uint32_t double_sided(std::uint32_t material);
  /// The set of texture coordinates along which the material needs tangents, if it does. Not where
  /// its normal texture is turned or mirrored: tangents belong to untransformed coordinates, and
  /// the frame is then better taken from each triangle.
  [[nodiscard]] std::optional<std::uint32_t> tangent_set(std::uint32_t material) const;
  /// Whether a surface of the material may have points that are cut away (alphaMode MASK).
  [[nodiscard]] bool may_have_holes(std::uint32_t material, bool has_vertex_colors) const;

 private:
  std::vector<shading::Material>& materials_;
  std::size_t gltf_size_;
  std::optional<std::uint32_t> default_;
  std::map<std::uint32_t, std::uint32_t> double_sided_;
};

}  // namespace lume::io::gltf
