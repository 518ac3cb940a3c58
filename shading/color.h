// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

#include <algorithm>
#include <cmath>

namespace lume::shading {

using geometry::Vec2;
using geometry::Vec3;
using geometry::Vec4;

/// Linear Rec.709 (scene-linear, D65). Radiance is in cd/m^2 (nits) throughout, as glTF gives
/// candela, lux and nits: a photometric renderer needs no 683 lm/W.
using Color = Vec3;

/// Relative luminance of linear Rec.709 (ITU-R BT.709, section 3).
[[nodiscard]] inline float luminance(const Color& c) {
  return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

[[nodiscard]] inline float max_component(const Color& c) { return std::max({c.x, c.y, c.z}); }

/// IEC 61966-2-1: encoded sRGB in [0, 1] to linear.
[[nodiscard]] inline float srgb_to_linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace lume::shading
