// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

namespace lume::geometry {

using DVec2 = glm::dvec2;

/// A point of a shape, in its object's space: what the differential geometry of surfaces says of
/// it. u grows to the right and v downwards in the image that covers the surface, as seen from the
/// front; so dp_dv x dp_du is on the side of the normal.
struct ShapePoint {
  DVec3 position{0.0};          ///< on the surface, to a few units in a double's last place
  DVec3 normal{0.0, 1.0, 0.0};  ///< towards the front, of any length
  DVec2 uv{0.0};                ///< texture coordinates
  DVec3 dp_du{1.0, 0.0, 0.0};   ///< partial derivatives of the position
  DVec3 dp_dv{0.0, 0.0, 1.0};
};

}  // namespace lume::geometry
