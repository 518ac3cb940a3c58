// SPDX-License-Identifier: Apache-2.0
// The box around the origin: the intersection of three slabs.
#pragma once

#include "geometry/shapes/face.h"
#include "geometry/shapes/span.h"

namespace lume::geometry {

struct Box {
  DVec3 half_size{0.5};  ///< half the full extents (metres)

  /// The largest dot(p, direction) over all points p.
  [[nodiscard]] double support(const DVec3& direction) const {
    return dot(half_size, glm::abs(direction));
  }

  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const {
    if (std::isnan(dot(ray.origin, ray.direction))) return std::nullopt;
    const auto axis_slab = [&](int axis) {
      return slab(ray.origin, ray.direction, axis, -half_size[axis], half_size[axis],
                  2 * static_cast<std::uint32_t>(axis));
    };
    return first_end(intersection(intersection(axis_slab(0), axis_slab(1)), axis_slab(2)), ray);
  }

  /// Crossing::part is the face; the image covers each of the six.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const {
    return face_point(near, crossing.part, -half_size, half_size);
  }
};

}  // namespace lume::geometry
