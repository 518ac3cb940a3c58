// SPDX-License-Identifier: Apache-2.0
// WebP goes past OpenImageIO 2.4, which returns it premultiplied in 8 bits: what is lost in
// transparent texels cannot be had back.
#include "io/read_webp.h"

#include "io/error.h"
#include "io/image_guards.h"

#include <webp/decode.h>

#include <cstdint>
#include <cstring>

namespace lume::io {

bool is_webp(std::span<const std::byte> bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

shading::Image read_webp(std::span<const std::byte> bytes, const std::string& name,
                         bool with_texels) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK) {
    throw Error(ErrorKind::input_output, name, "", "not a readable WebP image");
  }
  if (features.has_animation != 0) {
    throw Error(ErrorKind::input_output, name, "", "an animated WebP, expected a still image");
  }
  check_image_size(features.width, features.height, bytes.size(), name);

  shading::Image image{name, features.width, features.height, std::vector<std::uint8_t>{}};
  if (!with_texels) return image;
  auto& texels = std::get<std::vector<std::uint8_t>>(image.texels);
  const std::size_t stride = 4 * static_cast<std::size_t>(image.width);
  texels.resize(stride * static_cast<std::size_t>(image.height));
  if (WebPDecodeRGBAInto(data, bytes.size(), texels.data(), texels.size(),
                         static_cast<int>(stride)) == nullptr) {
    throw Error(ErrorKind::input_output, name, "", "the WebP data is damaged or cut short");
  }
  return image;
}

}  // namespace lume::io
