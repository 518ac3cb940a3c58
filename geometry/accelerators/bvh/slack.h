// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"
#include "geometry/crossing.h"

namespace lume::geometry::bvh {

/// How much wider a volume has to be for no ray to miss it that meets what is in it: what is
/// rounded in the test of the volume, and in that of the primitive, is some tens of 2^-53 of the
/// distances between the ray's origin and the far side of `all`, which is around everything. This
/// is some 900 times 2^-53, the same as for boxes (SlabRay).
[[nodiscard]] inline double slack_of(const ObjectRay& ray, const Bounds& all) {
  constexpr double k_rounding = 1e-13;
  const DVec3 size =
      glm::abs(ray.origin) + DVec3(glm::max(glm::abs(all.lower), glm::abs(all.upper)));
  return k_rounding * (size.x + size.y + size.z);
}

}  // namespace lume::geometry::bvh
