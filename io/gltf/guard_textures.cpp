// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/checker.h"
#include "io/gltf/guards.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace lume::io::gltf {
namespace {

/// The numbers of OpenGL that a sampler's property may have.
void check_choice(const JsonView& sampler, std::string_view key,
                  std::initializer_list<std::uint64_t> choices) {
  const std::optional<JsonView> value = sampler.find(key);
  if (value && std::find(choices.begin(), choices.end(), value->integer()) == choices.end()) {
    std::string list;
    for (const std::uint64_t choice : choices) {
      list += fmt::format("{}{}", list.empty() ? "" : ", ", choice);
    }
    value->fail(fmt::format("is {}, expected one of {}", value->integer(), list));
  }
}

void check_sampler(const JsonView& sampler) {
  check_choice(sampler, "magFilter", {9728, 9729});
  check_choice(sampler, "minFilter", {9728, 9729, 9984, 9985, 9986, 9987});
  check_choice(sampler, "wrapS", {33071, 33648, 10497});
  check_choice(sampler, "wrapT", {33071, 33648, 10497});
}

void check_image(const JsonView& image, std::size_t views) {
  static_cast<void>(image.text_or("name", ""));
  static_cast<void>(image.text_or("uri", ""));
  static_cast<void>(image.text_or("mimeType", ""));
  static_cast<void>(image.index_of("bufferView", views, "bufferViews"));
  if (image.has("uri") == image.has("bufferView")) {
    image.fail("expected either 'uri' or 'bufferView'");
  }
}

void check_texture(const JsonView& texture, std::size_t samplers, std::size_t images) {
  static_cast<void>(texture.text_or("name", ""));
  static_cast<void>(texture.index_of("sampler", samplers, "samplers"));
  static_cast<void>(texture.index_of("source", images, "images"));
  for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu"}) {
    if (const std::optional<JsonView> extension = texture.extension(name)) {
      static_cast<void>(extension->index_of("source", images, "images"));
    }
  }
  static_cast<void>(find_checker(texture));
}

}  // namespace

void check_textures(const JsonView& root) {
  const std::size_t views = root.items("bufferViews").size();
  const std::vector<JsonView> samplers = root.items("samplers");
  std::for_each(samplers.begin(), samplers.end(), check_sampler);
  const std::vector<JsonView> images = root.items("images");
  for (const JsonView& image : images) {
    check_image(image, views);
  }
  for (const JsonView& texture : root.items("textures")) {
    check_texture(texture, samplers.size(), images.size());
  }
}

}  // namespace lume::io::gltf
