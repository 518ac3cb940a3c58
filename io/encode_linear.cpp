// SPDX-License-Identifier: Apache-2.0
// Scene-linear files: radiance as it was rendered, without exposure and view.
#include "io/encode.h"
#include "io/error.h"
#include "io/nearest_name.h"
#include "io/picture_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace lume::io {
namespace {

constexpr float k_largest_half = 65504.0f;

// ITU-R BT.709: x and y of red, green, blue and white.
constexpr std::array<float, 8> k_rec709 = {0.64f, 0.33f, 0.30f,   0.60f,
                                           0.15f, 0.06f, 0.3127f, 0.3290f};

/// A half beyond its range would become infinite on file.
float fit_half(float value) {
  return std::isnan(value) ? 0.0f : std::clamp(value, -k_largest_half, k_largest_half);
}

void add_channel(OIIO::ImageSpec& spec, const std::string& name, bool full_precision) {
  spec.channelnames.push_back(name);
  spec.channelformats.push_back(full_precision ? OIIO::TypeFloat : OIIO::TypeHalf);
  ++spec.nchannels;
}

void add_channels(OIIO::ImageSpec& spec, const Picture& picture, const WriteOptions& options) {
  for (const char* name : {"R", "G", "B", "A"}) add_channel(spec, name, options.full_float);
  for (const Layer& layer : picture.layers) {
    for (const std::string& name : layer.channels) add_channel(spec, name, layer.full_precision);
  }
  spec.alpha_channel = 3;
}

void add_metadata(OIIO::ImageSpec& spec, const Picture& picture) {
  for (const auto& [key, value] : picture.metadata) spec.attribute(key, value);
  spec.attribute("Software", software_name());
  spec.attribute("DateTime", "");  // or OpenImageIO writes the time: same command, same bytes
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), k_rec709.data());
  if (picture.world_to_camera.size() == 16) {
    spec.attribute("worldToCamera", OIIO::TypeMatrix, picture.world_to_camera.data());
  }
}

OIIO::ImageSpec exr_spec(const Picture& picture, const WriteOptions& options,
                         const std::string& name) {
  static const std::vector<std::string> k_compressions = {"none",  "rle", "zip",  "zips", "piz",
                                                          "pxr24", "b44", "b44a", "dwaa", "dwab"};
  if (std::find(k_compressions.begin(), k_compressions.end(), options.compression) ==
      k_compressions.end()) {
    throw Error(ErrorKind::input_output, name, "",
                "OpenEXR has no compression '" + options.compression + "'" +
                    list_names(options.compression, k_compressions));
  }
  OIIO::ImageSpec spec(picture.region.width, picture.region.height, 0, OIIO::TypeHalf);
  spec.x = picture.region.x;
  spec.y = picture.region.y;
  spec.full_width = picture.full_width;
  spec.full_height = picture.full_height;
  add_channels(spec, picture, options);
  add_metadata(spec, picture);
  spec.attribute("compression", options.compression);
  return spec;
}

/// The channels of the beauty and of all layers at one pixel, in the order of the spec.
void gather_pixel(const Picture& picture, std::size_t pixel, const OIIO::ImageSpec& spec,
                  float* out) {
  const float* begin = out;
  out = std::copy_n(&picture.pixels[pixel].x, 4, out);
  for (const Layer& layer : picture.layers) {
    const std::size_t count = layer.channels.size();
    out =
        std::copy_n(layer.pixels.begin() + static_cast<std::ptrdiff_t>(pixel * count), count, out);
  }
  const auto written = static_cast<std::size_t>(out - begin);
  for (std::size_t c = 0; c < written; ++c) {
    float& value = out[static_cast<std::ptrdiff_t>(c) - static_cast<std::ptrdiff_t>(written)];
    if (spec.channelformats[c] == OIIO::TypeHalf) value = fit_half(value);
  }
}

/// In bands of rows: all layers of a large picture side by side would need its memory twice.
bool write_bands(OIIO::ImageOutput& output, const Picture& picture) {
  constexpr int k_band =
      64;  // a multiple of the rows that any compression packs together, but dwab
  const OIIO::ImageSpec& spec = output.spec();
  const auto width = static_cast<std::size_t>(picture.region.width);
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> band(width * k_band * channels);
  for (int first = 0; first < picture.region.height; first += k_band) {
    const int rows = std::min(k_band, picture.region.height - first);
    const std::size_t start = static_cast<std::size_t>(first) * width;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows) * width; ++i) {
      gather_pixel(picture, start + i, spec, &band[i * channels]);
    }
    const int y = picture.region.y + first;
    if (!output.write_scanlines(y, y + rows, 0, OIIO::TypeFloat, band.data())) return false;
  }
  return true;
}

/// Red, green and blue of every pixel, associated with alpha as they are: over black.
std::vector<shading::Color> colors_of(const Picture& picture) {
  std::vector<shading::Color> colors;
  colors.reserve(picture.pixels.size());
  for (const shading::Vec4& pixel : picture.pixels) colors.emplace_back(pixel);
  return colors;
}

}  // namespace

Bytes encode_exr(const Picture& picture, const WriteOptions& options, const std::string& name) {
  return encode("openexr", exr_spec(picture, options, name), name,
                [&](OIIO::ImageOutput& output) { return write_bands(output, picture); });
}

Bytes encode_hdr(const Picture& picture, const std::string& name) {
  OIIO::ImageSpec spec(picture.region.width, picture.region.height, 3, OIIO::TypeFloat);
  spec.attribute("Software", software_name());
  const std::vector<shading::Color> colors = colors_of(picture);
  return encode("hdr", spec, name, [&](OIIO::ImageOutput& output) {
    return output.write_image(OIIO::TypeFloat, colors.data());
  });
}

Bytes encode_pfm(const Picture& picture) {
  // Debevec's portable float map: rows go from the bottom up, a negative scale is little endian.
  static_assert(std::endian::native == std::endian::little);
  const std::string header =
      fmt::format("PF\n{} {}\n-1.0\n", picture.region.width, picture.region.height);
  const std::vector<shading::Color> colors = colors_of(picture);
  const std::size_t row_bytes =
      static_cast<std::size_t>(picture.region.width) * sizeof(shading::Color);
  Bytes bytes(header.begin(), header.end());
  bytes.resize(header.size() + colors.size() * sizeof(shading::Color));
  unsigned char* out = bytes.data() + header.size();
  for (int y = picture.region.height - 1; y >= 0; --y, out += row_bytes) {
    const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.region.width);
    std::memcpy(out, &colors[first], row_bytes);
  }
  return bytes;
}

}  // namespace lume::io
