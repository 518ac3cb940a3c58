// SPDX-License-Identifier: Apache-2.0
#include "io/report/packed_image.h"

#include "io/base64.h"

#include <OpenImageIO/half.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <new>
#include <string_view>

namespace lume::io {
namespace {

using Codes = std::vector<std::uint32_t>;

constexpr float k_largest_half = 65504.0f;
/// zlib's. Higher ones take twice the time to save one part in a hundred of a noisy image.
constexpr int k_compression_level = 4;
/// Images of more pixels are kept as half floats even where that rounds.
constexpr std::size_t k_most_pixels_as_floats = 16384;
/// Of an 8-bit code: what decoding and encoding again in single precision stays well below.
constexpr float k_code_tolerance = 0.02f;

float to_half_range(float value) {
  return std::isfinite(value) ? std::clamp(value, -k_largest_half, k_largest_half) : value;
}

/// IEC 61966-2-1, from linear to encoded; what is not in [0, 1], as the nearer end.
float encode_srgb(float linear) {
  if (!(linear > 0.0f)) return 0.0f;
  if (linear >= 1.0f) return 1.0f;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// The codes of all pixels' red, then green, then blue.
template <class Encode>
Codes encode_planes(const RgbImage& image, const Encode& encode) {
  Codes codes;
  codes.reserve(3 * image.pixels.size());
  for (int c = 0; c < 3; ++c) {
    for (const shading::Color& pixel : image.pixels) codes.push_back(encode(pixel[c]));
  }
  return codes;
}

/// In place, from the last to the first; numbers wrap around, as do the browser's.
void store_distances(Codes& codes, std::size_t width, std::size_t pixels) {
  if (codes.size() == 3 * pixels) {
    for (std::size_t i = 0; i < pixels; ++i) {
      codes[i] -= codes[pixels + i];
      codes[2 * pixels + i] -= codes[pixels + i];
    }
  }
  for (std::size_t i = codes.size(); i-- > 0;) {
    const std::size_t in_plane = i % pixels;
    // The first of a row has its neighbour above.
    const std::size_t distance = in_plane % width == 0 ? width : 1;
    if (in_plane >= distance) codes[i] -= codes[i - distance];
  }
}

/// Of each plane all highest bytes, then all second ones, and so on.
std::string split_bytes(const Codes& codes, std::size_t pixels, int bytes) {
  std::string split;
  split.reserve(codes.size() * static_cast<std::size_t>(bytes));
  for (std::size_t plane = 0; plane < codes.size(); plane += pixels) {
    for (int k = bytes - 1; k >= 0; --k) {
      for (std::size_t i = plane; i < plane + pixels; ++i) {
        split.push_back(static_cast<char>(static_cast<unsigned char>(codes[i] >> (8 * k))));
      }
    }
  }
  return split;
}

std::string deflate_bytes(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), k_compression_level);
  if (status != Z_OK) throw std::bad_alloc();  // the only way left to fail
  packed.resize(size);
  return packed;
}

PackedImage pack(const char* format, int bytes, Codes codes, int width, int height) {
  PackedImage packed{format, width, height, false, {}};
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (pixels == 0) return packed;
  store_distances(codes, static_cast<std::size_t>(width), pixels);
  packed.data = base64_encode(deflate_bytes(split_bytes(codes, pixels, bytes)));
  return packed;
}

template <class Predicate>
bool all_values(const RgbImage& image, const Predicate& predicate) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [&](const shading::Color& pixel) {
    return predicate(pixel.x) && predicate(pixel.y) && predicate(pixel.z);
  });
}

/// IEEE 754-2008, binary16: eleven digits, or multiples of 2^-24 below 2^-14.
bool is_half(float value) {
  if (!std::isfinite(value)) return true;
  const float size = std::abs(value);
  if (size < 0x1p-14f) return size * 0x1p24f == std::floor(size * 0x1p24f);
  return size <= k_largest_half && (std::bit_cast<std::uint32_t>(size) & 0x1FFFu) == 0;
}

bool is_8_bit(float value) {
  const float code = 255.0f * encode_srgb(value);
  return std::abs(code - std::round(code)) < k_code_tolerance;
}

}  // namespace

PackedImage pack_scene_linear(const RgbImage& image) {
  const bool exact = all_values(image, is_half);
  if (!exact && image.pixels.size() <= k_most_pixels_as_floats) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return pack("float", 4, encode_planes(image, bits), image.width, image.height);
  }
  const auto bits = [](float value) -> std::uint32_t { return half(to_half_range(value)).bits(); };
  PackedImage packed = pack("half", 2, encode_planes(image, bits), image.width, image.height);
  packed.rounded = !exact;
  return packed;
}

PackedImage pack_display_referred(const RgbImage& image) {
  const bool narrow = all_values(image, is_8_bit);
  const float most = narrow ? 255.0f : 65535.0f;
  const auto code = [most](float value) {
    return static_cast<std::uint32_t>(std::lround(most * encode_srgb(value)));
  };
  return pack(narrow ? "srgb8" : "srgb16", narrow ? 1 : 2, encode_planes(image, code), image.width,
              image.height);
}

PackedImage pack_map(std::span<const float> values, int width, int height) {
  Codes codes;
  codes.reserve(values.size());
  for (const float value : values) {
    const float inside = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
    codes.push_back(static_cast<std::uint32_t>(std::lround(255.0f * inside)));
  }
  return pack("unit8", 1, std::move(codes), width, height);
}

}  // namespace lume::io
