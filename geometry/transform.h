// SPDX-License-Identifier: Apache-2.0
// Transformed objects by the course's rule: the ray goes into the object's space by the inverse,
// the point comes back out, and normals go by the inverse transpose. Matrices are kept in double so
// that the way in and the way out cancel to far below a float's precision.
#pragma once

#include "geometry/bounds.h"
#include "geometry/math.h"

#include <cmath>

namespace lume::geometry {

/// An affine map from object space to the scene's frame, with its inverse.
class Transform {
 public:
  Transform() = default;
  /// `matrix` must be affine (last row 0 0 0 1) and is_invertible.
  explicit Transform(const DMat4& matrix)
      : linear_(matrix), translation_(matrix[3]), inverse_(glm::inverse(linear_)) {}

  /// False for a matrix that flattens space (a zero scale) or is not finite.
  [[nodiscard]] static bool is_invertible(const DMat4& matrix) {
    const DMat3 linear(matrix);
    const double determinant = std::abs(glm::determinant(linear));
    const double size = length(linear[0]) * length(linear[1]) * length(linear[2]);
    const DVec3 translation(matrix[3]);
    const bool finite = std::isfinite(size) && std::isfinite(dot(translation, translation));
    // Relative to the axes' lengths the determinant is the volume of a unit cell: 1 for any
    // rotation with scales, 0 for a flattened one. The absolute bounds keep a float matrix
    // invertible too.
    return finite && size > 1e-30 && size < 1e30 && determinant > 1e-9 * size;
  }

  [[nodiscard]] DVec3 point_to_world(const DVec3& p) const { return linear_ * p + translation_; }
  [[nodiscard]] DVec3 vector_to_world(const DVec3& v) const { return linear_ * v; }
  /// A covector: stays on the same side of its surface under mirroring. Not a unit vector.
  [[nodiscard]] DVec3 normal_to_world(const DVec3& n) const { return n * inverse_; }
  [[nodiscard]] DVec3 point_to_object(const DVec3& p) const {
    return inverse_ * (p - translation_);
  }
  [[nodiscard]] DVec3 vector_to_object(const DVec3& v) const { return inverse_ * v; }

  [[nodiscard]] const DMat3& linear() const { return linear_; }
  [[nodiscard]] const DVec3& translation() const { return translation_; }
  [[nodiscard]] const DMat3& inverse_linear() const { return inverse_; }

  /// The tightest box around the transformed box's corners.
  [[nodiscard]] Bounds bounds_to_world(const Bounds& bounds) const {
    Bounds result;
    for (int corner = 0; corner < 8 && !bounds.is_empty(); ++corner) {
      result.add(Vec3(point_to_world({(corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                                      (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                      (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z})));
    }
    return result;
  }

 private:
  DMat3 linear_{1.0};
  DVec3 translation_{0.0};
  DMat3 inverse_{1.0};
};

}  // namespace lume::geometry
