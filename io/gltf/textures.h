// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/gltf/document.h"
#include "io/gltf/notes.h"
#include "shading/image.h"
#include "shading/texture.h"

#include <map>
#include <optional>
#include <vector>

namespace lume::io::gltf {

/// The textures and images that materials use, numbered in the order of first use. What no material
/// uses is not loaded.
class TextureTable {
 public:
  TextureTable(const Document& document, Notes& notes);

  /// The scene's number for the glTF texture; TextureUse::k_none if that has neither an
  /// image nor a checker. Throws Error(scene) if its image is in a format that Lume cannot read.
  std::uint32_t use(std::size_t gltf_texture);

  /// The number of textures in the file.
  [[nodiscard]] std::size_t gltf_size() const { return gltf_textures_.size(); }
  [[nodiscard]] const std::vector<shading::Texture>& textures() const { return textures_; }
  /// Loads and decodes all images in parallel. Without `decode` they get their size but no texels.
  [[nodiscard]] std::vector<shading::Image> load_images(bool decode) const;

 private:
  /// Nothing for a texture without an image.
  [[nodiscard]] std::optional<shading::Texture> read_texture(std::size_t gltf_texture);
  [[nodiscard]] std::uint32_t use_image(std::size_t gltf_image);

  const Document* document_;
  Notes* notes_;
  std::vector<JsonView> gltf_textures_;
  std::vector<JsonView> gltf_images_;
  std::vector<shading::Texture> textures_;
  std::vector<std::size_t> images_;  ///< glTF image of each scene image
  std::map<std::size_t, std::uint32_t> by_texture_;
  std::map<std::size_t, std::uint32_t> by_image_;
};

}  // namespace lume::io::gltf
