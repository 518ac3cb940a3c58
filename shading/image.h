// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/color.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lume::shading {

/// How the numbers of an image's RGB are to be read. Alpha is always linear.
enum class Encoding { linear, srgb };

/// Four interleaved channels (RGBA, unassociated alpha), row 0 at the top. Texels stay in the
/// precision of their file, which is what they cost in memory.
struct Image {
  using Texels =
      std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

  std::string name;
  int width = 0;
  int height = 0;
  Texels texels;  ///< 4 * width * height values; integers are normalized to [0, 1]

  [[nodiscard]] std::size_t memory_bytes() const;
};

/// A rectangle of pixels; (0, 0) is the top left corner of the whole image.
struct PixelRegion {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const PixelRegion&) const = default;
};

}  // namespace lume::shading
