// SPDX-License-Identifier: Apache-2.0
// Several lookups happen at each hit, so everything that depends on the texture alone (its type,
// encoding and wrapping) is settled before the four texels are fetched.
#include "shading/texture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace lume::shading {
namespace {

/// The two neighbours along one axis and the weight of the second.
struct Taps {
  std::size_t first = 0;
  std::size_t second = 0;
  float weight = 0.0f;
};

/// The texel that shows at index i, at most one period outside of the image.
int wrap_index(int i, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return i < 0 ? i + size : (i >= size ? i - size : i);
    case Wrap::mirrored_repeat:
      if (i >= size) i = 2 * size - 1 - i;
      return i < 0 ? -1 - i : i;
    case Wrap::clamp_to_edge:
      break;
  }
  return std::clamp(i, 0, size - 1);
}

/// Brings a coordinate into the one period of the texture: [0, 1], or [0, 2] when mirrored. The
/// differences are exact in floating point up to the rounding of tiny negative values to the end of
/// the period, which wrap_index() accepts.
float reduce(float coordinate, Wrap wrap) {
  if (!std::isfinite(coordinate)) return 0.0f;
  switch (wrap) {
    case Wrap::repeat:
      return coordinate - std::floor(coordinate);
    case Wrap::mirrored_repeat:
      return coordinate - 2.0f * std::floor(0.5f * coordinate);
    case Wrap::clamp_to_edge:
      break;
  }
  return std::clamp(coordinate, 0.0f, 1.0f);
}

std::size_t nearest_tap(float coordinate, int size, Wrap wrap) {
  const int i = static_cast<int>(reduce(coordinate, wrap) * static_cast<float>(size));
  return static_cast<std::size_t>(wrap_index(i, size, wrap));
}

/// Texel i has its centre at (i + 0.5) / size.
Taps linear_taps(float coordinate, int size, Wrap wrap) {
  const float x = reduce(coordinate, wrap) * static_cast<float>(size) - 0.5f;
  const float below = std::floor(x);
  const int i = static_cast<int>(below);
  return {static_cast<std::size_t>(wrap_index(i, size, wrap)),
          static_cast<std::size_t>(wrap_index(i + 1, size, wrap)), x - below};
}

template <typename T>
std::vector<float> make_srgb_table() {
  constexpr std::size_t k_last = std::numeric_limits<T>::max();
  std::vector<float> table(k_last + 1);
  for (std::size_t i = 0; i <= k_last; ++i) {
    table[i] = srgb_to_linear(static_cast<float>(i) / static_cast<float>(k_last));
  }
  return table;
}

/// Decodes texels of integers: sRGB through a table, linear ones by one multiplication.
template <typename T>
struct SrgbTexels {
  const T* values;
  const float* table;
  Vec4 operator()(std::size_t i) const {
    constexpr float k_unit = 1.0f / static_cast<float>(std::numeric_limits<T>::max());
    const T* t = values + 4 * i;
    return {table[t[0]], table[t[1]], table[t[2]], static_cast<float>(t[3]) * k_unit};
  }
};

template <>
struct SrgbTexels<float> {
  const float* values;
  const float* table;
  Vec4 operator()(std::size_t i) const {
    const float* t = values + 4 * i;
    return {srgb_to_linear(t[0]), srgb_to_linear(t[1]), srgb_to_linear(t[2]), t[3]};
  }
};

template <typename T>
struct LinearTexels {
  const T* values;
  Vec4 operator()(std::size_t i) const {
    const T* t = values + 4 * i;
    const Vec4 value{static_cast<float>(t[0]), static_cast<float>(t[1]), static_cast<float>(t[2]),
                     static_cast<float>(t[3])};
    if constexpr (std::is_integral_v<T>) {
      return value * (1.0f / static_cast<float>(std::numeric_limits<T>::max()));
    } else {
      return value;
    }
  }
};

template <typename Texels>
Vec4 filter_texels(const Texture& texture, const Image& image, const Texels& texel, Vec2 uv) {
  const auto width = static_cast<std::size_t>(image.width);
  if (texture.filter == Filter::nearest) {
    const std::size_t x = nearest_tap(uv.x, image.width, texture.wrap_u);
    return texel(nearest_tap(uv.y, image.height, texture.wrap_v) * width + x);
  }
  const Taps x = linear_taps(uv.x, image.width, texture.wrap_u);
  const Taps y = linear_taps(uv.y, image.height, texture.wrap_v);
  const std::size_t top = y.first * width;
  const std::size_t bottom = y.second * width;
  const Vec4 upper = glm::mix(texel(top + x.first), texel(top + x.second), x.weight);
  const Vec4 lower = glm::mix(texel(bottom + x.first), texel(bottom + x.second), x.weight);
  return glm::mix(upper, lower, y.weight);
}

template <typename T>
const float* srgb_table() {
  if constexpr (std::is_integral_v<T>) {
    static const std::vector<float> table = make_srgb_table<T>();
    return table.data();
  } else {
    return nullptr;
  }
}

}  // namespace

Vec4 Checker::value(Vec2 uv) const {
  // Halves of whole numbers are exact, and so the parity is found without a conversion to integers,
  // which might overflow.
  const float half = 0.5f * (std::floor(checks.x * uv.x) + std::floor(checks.y * uv.y));
  return colors[half == std::floor(half) ? 0 : 1];
}

Vec2 TextureTransform::apply(Vec2 uv) const {
  if (rotation == 0.0f) return offset + scale * uv;  // by far the most common
  return offset + linear() * uv;
}

glm::mat2 TextureTransform::linear() const {
  // Rotation * scale; the README of KHR_texture_transform rotates the coordinates clockwise as seen
  // with v pointing down, which is counter-clockwise with v up. Its example (offset (0, 1),
  // rotation pi/2, scale 1/2 selects the lower left quadrant) fixes the sign.
  const float c = std::cos(rotation);
  const float s = std::sin(rotation);
  return {scale.x * Vec2(c, -s), scale.y * Vec2(s, c)};
}

Vec4 sample_texture(const Texture& texture, const Image& image, Encoding encoding, Vec2 uv) {
  if (image.width <= 0 || image.height <= 0) return Vec4(1.0f);
  return std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if (encoding == Encoding::srgb) {
          const SrgbTexels<T> texels{values.data(), srgb_table<T>()};
          return filter_texels(texture, image, texels, uv);
        }
        return filter_texels(texture, image, LinearTexels<T>{values.data()}, uv);
      },
      image.texels);
}

}  // namespace lume::shading
