// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/color.h"

#include <cstddef>
#include <vector>

namespace lume::io {

/// What metrics of colour look at: linear Rec.709, row 0 at the top. Values of a display image are
/// in [0, 1] once decoded from sRGB; those of a scene-linear one have no end.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<shading::Color> pixels;  ///< width * height

  [[nodiscard]] const shading::Color& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

}  // namespace lume::io
