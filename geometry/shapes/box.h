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
    return first_end(box_span(ray.origin, ray.direction, {-half_size, half_size}, 0), ray);
  }

  /// Crossing::part is the face; the image covers each of the six.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const {
    return face_point(near, crossing.part, -half_size, half_size);
  }
};

}  // namespace lume::geometry
