// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/textures.h"

#include "geometry/parallel.h"
#include "io/gltf/checker.h"
#include "io/gltf/resources.h"
#include "io/image_io.h"

#include <fmt/format.h>

#include <cstring>
#include <optional>

namespace lume::io::gltf {
namespace {

shading::Wrap to_wrap(int gltf) {
  if (gltf == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) {
    return shading::Wrap::clamp_to_edge;
  }
  return gltf == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? shading::Wrap::mirrored_repeat
                                                       : shading::Wrap::repeat;
}

/// The glTF image behind a texture. WebP is preferred to its fallback, as EXT_texture_webp asks;
/// KHR_texture_basisu is not readable, so its fallback is needed.
std::optional<std::size_t> image_of(const JsonView& texture, std::size_t images) {
  if (const std::optional<JsonView> webp = texture.extension("EXT_texture_webp")) {
    if (const auto source = webp->index_of("source", images, "images")) {
      return source;
    }
  }
  const std::optional<std::size_t> source = texture.index_of("source", images, "images");
  if (!source && texture.extension("KHR_texture_basisu")) {
    const std::string name = texture.text_or("name", "");
    texture.fail(
        fmt::format("texture {}is KTX2 (KHR_texture_basisu), which cannot be read; "
                    "expected a PNG or JPEG \"source\" beside it",
                    name.empty() ? "" : "'" + name + "' "));
  }
  return source;
}

/// What a user would call the image.
std::string image_name(const JsonView& image, std::size_t index) {
  std::string name = image.text_or("name", "");
  const std::string uri = image.text_or("uri", "");
  if (!name.empty()) {
    return name;
  }
  return uri.empty() || uri.starts_with("data:") ? fmt::format("image {}", index)
                                                 : percent_decode(uri);
}

/// The first bytes of every KTX2 file (Khronos Texture 2.0, section 3.1).
bool is_ktx2(Bytes bytes) {
  constexpr unsigned char k_identifier[] = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB};
  return bytes.size() >= sizeof(k_identifier) &&
         std::memcmp(bytes.data(), k_identifier, sizeof(k_identifier)) == 0;
}

shading::Image load_image(const Document& document, std::size_t index, const JsonView& image,
                          bool decode) {
  std::vector<std::byte> loaded;
  Bytes bytes;
  if (const std::optional<JsonView> uri = image.find("uri")) {
    loaded = load_uri(*uri, document.folder());
    bytes = loaded;
  } else {
    bytes = document.view_bytes(image.require("bufferView").integer());
  }
  if (is_ktx2(bytes)) {
    image.fail(
        fmt::format("image '{}' is KTX2 (KHR_texture_basisu), which cannot be read; "
                    "expected PNG, JPEG or WebP",
                    image_name(image, index)));
  }
  const std::string where = document.file + " at " + image.pointer();
  shading::Image result = decode ? decode_image(bytes, where) : probe_image(bytes, where);
  result.name = image_name(image, index);
  return result;
}

}  // namespace

TextureTable::TextureTable(const Document& document, Notes& notes)
    : document_(&document),
      notes_(&notes),
      gltf_textures_(document.root().items("textures")),
      gltf_images_(document.root().items("images")) {}

std::uint32_t TextureTable::use_image(std::size_t gltf_image) {
  const auto [it, is_new] =
      by_image_.try_emplace(gltf_image, static_cast<std::uint32_t>(images_.size()));
  if (is_new) {
    images_.push_back(gltf_image);
  }
  return it->second;
}

std::optional<shading::Texture> TextureTable::read_texture(std::size_t gltf_texture) {
  const JsonView& json = gltf_textures_[gltf_texture];
  shading::Texture result;
  result.checker = find_checker(json);
  if (result.checker) {
    note_unknown_checker_properties(json, fmt::format("texture {}", gltf_texture), *notes_);
    return result;  // an image beside it is for other viewers
  }
  const std::optional<std::size_t> image = image_of(json, gltf_images_.size());
  if (!image) {
    return std::nullopt;
  }
  result.image = use_image(*image);
  if (const int sampler = document_->model.textures[gltf_texture].sampler; sampler >= 0) {
    const tinygltf::Sampler& gltf = document_->model.samplers[static_cast<std::size_t>(sampler)];
    result.wrap_u = to_wrap(gltf.wrapS);
    result.wrap_v = to_wrap(gltf.wrapT);
    result.filter = gltf.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? shading::Filter::nearest
                                                                      : shading::Filter::linear;
  }
  return result;
}

std::uint32_t TextureTable::use(std::size_t gltf_texture) {
  const auto [it, is_new] = by_texture_.try_emplace(gltf_texture, shading::TextureUse::k_none);
  if (!is_new) {
    return it->second;
  }
  if (const std::optional<shading::Texture> texture = read_texture(gltf_texture)) {
    it->second = static_cast<std::uint32_t>(textures_.size());
    textures_.push_back(*texture);
  }
  return it->second;
}

std::vector<shading::Image> TextureTable::load_images(bool decode) const {
  std::vector<shading::Image> result(images_.size());
  geometry::parallel_for(images_.size(), [&](std::size_t i) {
    result[i] = load_image(*document_, images_[i], gltf_images_[images_[i]], decode);
  });
  return result;
}

}  // namespace lume::io::gltf
