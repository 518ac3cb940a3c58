// SPDX-License-Identifier: Apache-2.0
// A ray in an object's own space, and where it crosses a surface there. All in double: what a float
// accelerator names is looked up again at full precision.
#pragma once

#include "geometry/math.h"

#include <cstdint>
#include <limits>

namespace lume::geometry {

/// The line origin + t * direction, t_min <= t <= t_max, in an object's space. The direction is not
/// a unit vector: it is the scene's ray taken into object space, so that t means the same in both.
struct ObjectRay {
  DVec3 origin{0.0};
  DVec3 direction{0.0, 0.0, -1.0};
  double t_min = 0.0;
  double t_max = std::numeric_limits<double>::infinity();

  [[nodiscard]] DVec3 at(double t) const { return origin + t * direction; }
  [[nodiscard]] bool contains(double t) const { return t >= t_min && t <= t_max; }
};

/// Where a ray crosses a surface.
struct Crossing {
  double t = 0.0;
  double u = 0.0;  ///< of a triangle the barycentric coordinate of corner 1; of a patch its u
  double v = 0.0;  ///< of a triangle the barycentric coordinate of corner 2; of a patch its v
  std::uint32_t part = 0;  ///< of a shape: the face, side, cap or patch that is met
};

}  // namespace lume::geometry
