// SPDX-License-Identifier: Apache-2.0
// Pictures as a screen shows them: exposed, through the view transform, 8 bits.
#include "io/encode.h"
#include "io/error.h"
#include "io/picture_formats.h"

#include <fmt/format.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

namespace lume::io {
namespace {

using shading::Color;
using shading::Vec4;

struct DisplayFormat {
  std::string_view extension;
  const char* writer;  ///< OpenImageIO's name
  bool alpha;
};

// Few programs read the alpha of a BMP, so it has none here.
constexpr std::array k_formats = {
    DisplayFormat{".png", "png", true},    DisplayFormat{".jpg", "jpeg", false},
    DisplayFormat{".jpeg", "jpeg", false}, DisplayFormat{".tif", "tiff", true},
    DisplayFormat{".tiff", "tiff", true},  DisplayFormat{".webp", "webp", true},
    DisplayFormat{".bmp", "bmp", false},   DisplayFormat{".tga", "targa", true}};

constexpr auto k_extensions = [] {
  std::array<std::string_view, k_formats.size()> extensions;
  for (std::size_t i = 0; i < k_formats.size(); ++i) extensions[i] = k_formats[i].extension;
  return extensions;
}();

/// What goes through the view: the surface's own colour where the file keeps alpha, else the colour
/// over black, which is the associated one.
Color visible_color(const Vec4& pixel, bool keeps_alpha) {
  const Color color(pixel);
  if (!keeps_alpha) return color;
  return pixel.w > 0.0f ? color / pixel.w : Color(0.0f);
}

unsigned char to_byte(float value) {
  const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
  return static_cast<unsigned char>(std::lround(clamped * 255.0f));
}

Bytes develop(const Picture& picture, const WriteOptions& options, bool keeps_alpha) {
  const float scale = std::exp2(options.exposure);
  std::vector<Color> colors;
  colors.reserve(picture.pixels.size());
  for (const Vec4& pixel : picture.pixels) {
    colors.push_back(visible_color(pixel, keeps_alpha) * scale);
  }
  options.view.apply(colors);

  Bytes bytes;
  bytes.reserve(colors.size() * (keeps_alpha ? 4 : 3));
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (int c = 0; c < 3; ++c) bytes.push_back(to_byte(colors[i][c]));
    if (keeps_alpha) bytes.push_back(to_byte(picture.pixels[i].w));
  }
  return bytes;
}

OIIO::ImageSpec display_spec(const Picture& picture, const WriteOptions& options,
                             const DisplayFormat& format) {
  const int channels = format.alpha ? 4 : 3;
  OIIO::ImageSpec spec(picture.region.width, picture.region.height, channels, OIIO::TypeUInt8);
  spec.attribute("oiio:UnassociatedAlpha", 1);  // or it would multiply the alpha in
  spec.attribute("Software", software_name());
  spec.attribute("ImageDescription", fmt::format("{} on {}, exposure {:+g} EV", options.view.view(),
                                                 options.view.display(), options.exposure));
  // PNG alone: in a TIFF it becomes EXIF, which OpenImageIO 2.4 cannot write to memory
  // (its pull request 4300).
  if (format.extension == ".png" && options.view.display() == "sRGB") {
    spec.attribute("oiio:ColorSpace", "sRGB");
  }
  if (format.extension == ".jpg" || format.extension == ".jpeg") {
    spec.attribute("compression", fmt::format("jpeg:{}", std::clamp(options.jpeg_quality, 1, 100)));
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  return spec;
}

/// Not through OpenImageIO, whose writer is lossy.
Bytes encode_webp(const Picture& picture, const Bytes& pixels, const std::string& name) {
  std::uint8_t* data = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(
      pixels.data(), picture.region.width, picture.region.height, 4 * picture.region.width, &data);
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> owner(data, &WebPFree);
  if (size == 0) {
    throw Error(ErrorKind::input_output, name, "",
                fmt::format("cannot encode as WebP, which holds at most {0} x {0} pixels",
                            WEBP_MAX_DIMENSION));
  }
  return {data, data + size};
}

}  // namespace

std::span<const std::string_view> display_extensions() { return k_extensions; }

Bytes encode_display(const Picture& picture, const WriteOptions& options,
                     const std::string& extension, const std::string& name) {
  const auto* format = std::find_if(k_formats.begin(), k_formats.end(), [&](const auto& candidate) {
    return candidate.extension == extension;
  });
  if (format == k_formats.end()) {
    throw Error(ErrorKind::input_output, name, "", "no display format is called " + extension);
  }
  const Bytes pixels = develop(picture, options, format->alpha);
  if (extension == ".webp") return encode_webp(picture, pixels, name);
  return encode(format->writer, display_spec(picture, options, *format), name,
                [&](OIIO::ImageOutput& output) {
                  return output.write_image(OIIO::TypeUInt8, pixels.data());
                });
}

}  // namespace lume::io
