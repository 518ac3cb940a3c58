// SPDX-License-Identifier: Apache-2.0
// Keeps positions near zero, where floats are dense: a town surveyed in kilometres from some far
// origin would otherwise lose its centimetres.
#pragma once

#include "geometry/world.h"

#include <limits>

namespace lume::io::gltf {

/// A box in double precision.
struct DBounds {
  geometry::DVec3 lower{std::numeric_limits<double>::infinity()};
  geometry::DVec3 upper{-std::numeric_limits<double>::infinity()};

  void add(const geometry::DVec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  [[nodiscard]] bool is_empty() const { return lower.x > upper.x; }
};

/// If the object lies far from its own origin for its size, moves it there and returns the way back
/// (object positions + result = positions as they were, exactly). Otherwise zero.
[[nodiscard]] geometry::Vec3 recenter(geometry::Object& object);

/// Around the object's corners under the matrix.
[[nodiscard]] DBounds transformed(const geometry::Bounds& bounds, const geometry::DMat4& matrix);

/// The origin for a scene with these bounds: its centre if that is far for its size, else zero.
[[nodiscard]] geometry::DVec3 choose_origin(const DBounds& bounds);

}  // namespace lume::io::gltf
