// SPDX-License-Identifier: Apache-2.0
// The shape of the statue: a draped standing figure as the zero of a function of space.
#pragma once

#include "geometry/math.h"

namespace lume::generator {

/// Metres from the head's middle to the feet, which stand on y = 0.
inline constexpr float k_figure_eye_height = 1.66f;

/// About the distance to the figure's smooth surface in metres, negative inside. From the y axis
/// between the feet and the head, level or upwards, steps of this length lead to the surface.
[[nodiscard]] float figure_distance(const geometry::Vec3& p);

/// How far a chisel left the surface from there, along the outward direction (metres): folds in the
/// robe, hair, and roughness at every scale down to millimetres.
[[nodiscard]] float figure_relief(const geometry::Vec3& p);

}  // namespace lume::generator
