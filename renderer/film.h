// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/aov.h"
#include "shading/image.h"

#include <vector>

namespace lume::renderer {

/// The developed pixels of a region, row 0 at the top.
struct Film {
  shading::PixelRegion region;
  std::vector<shading::Vec4> pixels;  ///< scene-linear Rec.709 (nits), associated alpha
  struct Layer {
    Aov aov;
    std::vector<float> values;  ///< interleaved channels
  };
  std::vector<Layer> layers;  ///< in the order they were asked for
};

}  // namespace lume::renderer
