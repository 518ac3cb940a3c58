// SPDX-License-Identifier: Apache-2.0
// The surface f(x, y, z) = 0 within a box, f written as text. Along a ray f is a function of t
// alone, whose first root is isolated with interval arithmetic, so that none is skipped; the normal
// is the gradient of f.
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/expression.h"
#include "geometry/shapes/shape_point.h"
#include "geometry/shapes/tight_box.h"

#include <optional>

namespace lume::geometry {

class ImplicitSurface {
 public:
  /// The part of f = 0 between two corners of a box (finite, lower < upper).
  ImplicitSurface(Expression f, const DVec3& lower, const DVec3& upper);

  /// An upper bound of dot(p, direction) over all points p: of the tightest box around the surface
  /// that interval arithmetic proves, to about 1% of its size.
  [[nodiscard]] double support(const DVec3& direction) const;
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const;
  /// True if f is proven to have no root in the box: nothing will ever be met.
  [[nodiscard]] bool is_empty() const { return is_empty_; }
  /// u around the axis y, v from the top of the box to its bottom.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const;

 private:
  Expression f_;
  DBounds box_;    ///< that cuts the surface
  DBounds tight_;  ///< around what is left of the surface, and a little more
  bool is_empty_ = false;
};

}  // namespace lume::geometry
