// SPDX-License-Identifier: Apache-2.0
// Textures from memory. The content decides about the format; names and MIME types are often wrong.
#include "io/error.h"
#include "io/image_guards.h"
#include "io/image_io.h"
#include "io/one_line.h"
#include "io/read_webp.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>

namespace lume::io {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw Error(ErrorKind::input_output, name, "", one_line(reason));
}

/// A file name that leads OpenImageIO to the right reader at once; without an extension it lets all
/// of them look at the content, which takes a millisecond.
const char* telling_name(std::span<const std::byte> bytes) {
  if (is_jpeg(bytes)) return "image.jpg";
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "\x89PNG", 4) == 0) return "image.png";
  return "image";
}

std::unique_ptr<OIIO::ImageInput> open_image(OIIO::Filesystem::IOMemReader& reader,
                                             std::span<const std::byte> bytes,
                                             const std::string& name) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  // Beside a configuration the reader must be in it as well, or OpenImageIO 2.4 looks for a file.
  OIIO::Filesystem::IOProxy* proxy = &reader;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  auto input = OIIO::ImageInput::open(telling_name(bytes), &config, &reader);
  if (!input) {
    static_cast<void>(OIIO::geterror());  // it lists what each of its readers thought
    fail(name, "not an image in a format that can be read");
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.depth > 1 || spec.nchannels < 1) fail(name, "expected a flat image with channels");
  check_image_size(spec.width, spec.height, reader.size(), name);
  return input;
}

/// Grey (and alpha) stand in the first channels of each texel; spreads them over all four.
template <typename T>
void spread_grey(std::vector<T>& texels, bool with_alpha) {
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    if (with_alpha) texels[i + 3] = texels[i + 1];
    texels[i + 1] = texels[i + 2] = texels[i];
  }
}

template <typename T>
std::vector<T> read_texels(OIIO::ImageInput& input, const std::string& name) {
  constexpr T k_opaque = std::is_integral_v<T> ? std::numeric_limits<T>::max() : T{1};
  constexpr OIIO::stride_t k_stride = 4 * sizeof(T);
  const OIIO::ImageSpec& spec = input.spec();
  const int channels = std::min(spec.nchannels, 4);
  std::vector<T> texels(4 * spec.image_pixels(), k_opaque);
  if (!input.read_image(0, 0, 0, channels, OIIO::BaseTypeFromC<T>::value, texels.data(), k_stride,
                        k_stride * spec.width)) {
    fail(name, "the image is damaged: " + input.geterror());
  }
  if (channels < 3) spread_grey(texels, channels == 2);
  return texels;
}

shading::Image::Texels read_as_stored(OIIO::ImageInput& input, const std::string& name) {
  switch (input.spec().format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return read_texels<std::uint8_t>(input, name);
    case OIIO::TypeDesc::UINT16:
      return read_texels<std::uint16_t>(input, name);
    default:
      return read_texels<float>(input, name);
  }
}

}  // namespace

shading::Image decode_image(std::span<const std::byte> bytes, const std::string& name) {
  if (is_webp(bytes)) return read_webp(bytes, name, true);
  if (is_jpeg(bytes) && !is_complete_jpeg(bytes)) fail(name, "the JPEG data is cut short");
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  const auto input = open_image(reader, bytes, name);
  return {name, input->spec().width, input->spec().height, read_as_stored(*input, name)};
}

shading::Image probe_image(std::span<const std::byte> bytes, const std::string& name) {
  if (is_webp(bytes)) return read_webp(bytes, name, false);
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  const auto input = open_image(reader, bytes, name);
  return {name, input->spec().width, input->spec().height, {}};
}

}  // namespace lume::io
