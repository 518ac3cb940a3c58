// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lume::io::gltf {

/// The drawing modes of a primitive.
enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

/// The triangles of one of the three triangle modes. Indices that do not complete a triangle are
/// left out.
[[nodiscard]] std::vector<geometry::UVec3> triangulate(std::span<const std::uint32_t> indices,
                                                       Mode mode);

/// The same of the vertices 0 .. count - 1 in their order.
[[nodiscard]] std::vector<geometry::UVec3> triangulate(std::uint32_t count, Mode mode);

}  // namespace lume::io::gltf
