// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"

#include <array>

namespace lume::geometry {

/// Around the part of a triangle that is in `box`, rounded outwards but never beyond the box; empty
/// if there is none (Sutherland and Hodgman 1974, "Reentrant Polygon Clipping").
[[nodiscard]] Bounds clip_triangle(const std::array<Vec3, 3>& corners, const Bounds& box);

}  // namespace lume::geometry
