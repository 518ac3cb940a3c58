// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/color.h"
#include "shading/image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace lume::shading {

enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter { nearest, linear };

/// Squares in two colours (extension LUME_texture_checker).
struct Checker {
  std::array<Vec4, 2> colors{Vec4(1.0f), Vec4(0.0f, 0.0f, 0.0f, 1.0f)};  ///< linear RGBA
  Vec2 checks{2.0f};  ///< squares across the unit of u and of v

  /// The first colour where floor(checks.x u) + floor(checks.y v) is even, else the second.
  [[nodiscard]] Vec4 value(Vec2 uv) const;
};

/// An image with the sampler that reads it (a glTF texture), or a formula in its place.
struct Texture {
  std::uint32_t image = 0;  ///< index into Scene::images; of no meaning beside a checker
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter filter = Filter::linear;
  std::optional<Checker> checker = std::nullopt;
};

/// KHR_texture_transform: uv' = translate * rotate * scale * uv.
struct TextureTransform {
  Vec2 offset{0.0f};
  float rotation = 0.0f;  ///< radians; as the extension defines it, around the uv origin
  Vec2 scale{1.0f};

  [[nodiscard]] Vec2 apply(Vec2 uv) const;
  /// The part that turns and scales.
  [[nodiscard]] glm::mat2 linear() const;
};

/// A material's use of a texture.
struct TextureUse {
  static constexpr std::uint32_t k_none = ~0u;

  std::uint32_t texture = k_none;  ///< index into Scene::textures
  std::uint32_t texcoord = 0;      ///< set of the mesh
  TextureTransform transform;

  [[nodiscard]] explicit operator bool() const { return texture != k_none; }
};

/// The texture's value at uv, (0, 0) being the top left corner of the image. RGB is decoded before
/// it is filtered, so the result is linear RGBA.
[[nodiscard]] Vec4 sample_texture(const Texture& texture, const Image& image, Encoding encoding,
                                  Vec2 uv);

}  // namespace lume::shading
