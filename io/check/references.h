// SPDX-License-Identifier: Apache-2.0
// Which part of a glTF file points to which.
#pragma once

#include "io/gltf/json_view.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lume::io::check {

/// An item of one of the file's arrays: {"meshes", 3}.
struct Part {
  std::string array;
  std::size_t index = 0;

  auto operator<=>(const Part&) const = default;
};

/// What an item of `array` points to, its extensions included. Whether those parts exist is not
/// asked.
[[nodiscard]] std::vector<Part> references_of(const std::string& array, const gltf::Json& item);

/// A material's use of a texture.
struct TextureInfo {
  std::string key;          ///< "baseColorTexture"
  std::size_t texture = 0;  ///< index into the file's textures
  std::size_t texcoord = 0;
};

/// All of a material, its extensions included.
[[nodiscard]] std::vector<TextureInfo> texture_infos(const gltf::Json& material);

}  // namespace lume::io::check
