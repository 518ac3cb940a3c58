// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/shape_point.h"

namespace lume::geometry {

/// A point of one face of the box from `lower` to `upper`: face 2 * axis is the lower one of an
/// axis, 2 * axis + 1 the upper one. An image stands upright on the four sides, and on the top and
/// bottom as if one had walked there from the side +z.
[[nodiscard]] inline ShapePoint face_point(const DVec3& near, std::uint32_t face,
                                           const DVec3& lower, const DVec3& upper) {
  // The image's directions to the right and down, as axis and sign.
  struct Image {
    int right;
    double right_sign;
    int down;
    double down_sign;
  };
  constexpr Image k_images[6] = {{2, 1, 1, -1}, {2, -1, 1, -1}, {0, 1, 2, -1},
                                 {0, 1, 2, 1},  {0, -1, 1, -1}, {0, 1, 1, -1}};
  const Image& image = k_images[face];
  const int axis = static_cast<int>(face / 2);
  const bool is_upper = face % 2 == 1;
  const DVec3 size = upper - lower;
  const auto along = [&](int i, double sign) {
    const double part = (near[i] - lower[i]) / size[i];
    return sign > 0.0 ? part : 1.0 - part;
  };
  ShapePoint point;
  point.position = near;
  point.position[axis] = is_upper ? upper[axis] : lower[axis];
  point.normal = DVec3(0.0);
  point.normal[axis] = is_upper ? 1.0 : -1.0;
  point.uv = {along(image.right, image.right_sign), along(image.down, image.down_sign)};
  point.dp_du = DVec3(0.0);
  point.dp_du[image.right] = image.right_sign * size[image.right];
  point.dp_dv = DVec3(0.0);
  point.dp_dv[image.down] = image.down_sign * size[image.down];
  return point;
}

}  // namespace lume::geometry
