// SPDX-License-Identifier: Apache-2.0
// Keeps positions near zero, where floats are dense: a town surveyed in kilometres from some far
// origin would otherwise lose its centimetres.
#pragma once

#include "geometry/world.h"

namespace lume::io::gltf {

/// If the object lies far from its own origin for its size, moves it there and returns the way back
/// (object positions + result = positions as they were, exactly). Otherwise zero.
[[nodiscard]] geometry::Vec3 recenter(geometry::Object& object);

/// Around the object's corners under the matrix.
[[nodiscard]] geometry::DBounds transformed(const geometry::Bounds& bounds,
                                            const geometry::DMat4& matrix);

/// The origin for a scene with these bounds: its centre if that is far for its size, else zero.
[[nodiscard]] geometry::DVec3 choose_origin(const geometry::DBounds& bounds);

}  // namespace lume::io::gltf
