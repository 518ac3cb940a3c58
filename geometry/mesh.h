// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"
#include "geometry/math.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lume::geometry {

/// An indexed triangle mesh in its object's space (metres). Every attribute is either empty or has
/// one value for each position; every index is below positions.size().
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;                 ///< unit vectors; empty: flat facets
  std::vector<Vec4> tangents;                ///< xyz unit, w = handedness of the bitangent
  std::vector<std::vector<Vec2>> texcoords;  ///< by set
  std::vector<Vec4> colors;                  ///< linear RGB and alpha; empty: white
  std::vector<UVec3> triangles;              ///< counter-clockwise from the front

  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const {
    const UVec3& i = triangles[triangle];
    return {positions[i.x], positions[i.y], positions[i.z]};
  }
  [[nodiscard]] Bounds bounds() const;
  /// Heap memory held, in bytes.
  [[nodiscard]] std::size_t memory_bytes() const;
};

/// The value of a vertex attribute at barycentric (u, v): (1-u-v) a + u b + v c.
template <class T>
[[nodiscard]] T interpolate(const std::vector<T>& attribute, const UVec3& corners, Vec2 uv) {
  return attribute[corners.x] * (1.0f - uv.x - uv.y) + attribute[corners.y] * uv.x +
         attribute[corners.z] * uv.y;
}

}  // namespace lume::geometry
