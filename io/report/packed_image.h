// SPDX-License-Identifier: Apache-2.0
// Pictures as text that a browser unpacks with what it has: base64 and DecompressionStream. Noise
// hardly compresses, so values are first made small: in a plane, each is stored as its distance
// from the one to the left, red and blue as their distances from green, and high bytes stand apart
// from low ones (after the filters of PNG, ISO/IEC 15948:2004, section 9, and of OpenEXR's ZIP
// compression).
#pragma once

#include "io/compare/rgb_image.h"

#include <span>
#include <string>

namespace lume::io {

/// Whole numbers of 1, 2 or 4 bytes, in planes of R, G and B or in one. page/pixels.js unpacks
/// them.
struct PackedImage {
  /// What the numbers are: "half" or "float", by their bits; "srgb8" or "srgb16", encoded sRGB in
  /// 255ths or 65535ths; "unit8", 255ths of a map in [0, 1].
  std::string format;
  int width = 0;
  int height = 0;
  /// Half floats stand for values between them. Finite ones stay so: at most 65504.
  bool rounded = false;
  std::string data;  ///< base64 of a zlib stream (RFC 1950)
};

[[nodiscard]] PackedImage pack_scene_linear(const RgbImage& image);
[[nodiscard]] PackedImage pack_display_referred(const RgbImage& image);
/// Of width * height values; those outside of [0, 1] count as the nearer end.
[[nodiscard]] PackedImage pack_map(std::span<const float> values, int width, int height);

}  // namespace lume::io
