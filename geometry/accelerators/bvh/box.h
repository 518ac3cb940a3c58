// SPDX-License-Identifier: Apache-2.0
// The box along the axes as the volume of a hierarchy (Kay and Kajiya 1986).
#pragma once

#include "geometry/accelerators/bvh/tree.h"
#include "geometry/accelerators/slab.h"

#include <span>

namespace lume::geometry::bvh {

struct Box {
  using Ray = SlabRay;
  static constexpr bool k_needs_points = false;

  static Box around(const Bounds& box, std::span<const Vec3> /*points*/) { return {box}; }
  [[nodiscard]] Interval1D clip(const SlabRay& ray, double t_min, double t_max) const {
    return ray.clip(bounds, t_min, t_max);
  }

  Bounds bounds;
};

[[nodiscard]] inline double half_area(const Box& box) { return half_area(box.bounds); }

}  // namespace lume::geometry::bvh
