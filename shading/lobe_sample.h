// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/color.h"

namespace lume::shading {

/// A direction in which the recursion goes on.
struct LobeSample {
  Vec3 direction{0.0f};  ///< unit, away from the surface
  Color weight{0.0f};    ///< BSDF * cosine / density: what the light from there is multiplied by
  /// Per steradian; 0 for a mirror, whose density is infinite, and for lobes that no light is
  /// looked for in by other means.
  float pdf = 0.0f;
};

}  // namespace lume::shading
