// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh.h"

namespace lume::geometry {

Bounds Mesh::bounds() const {
  Bounds result;
  for (const Vec3& position : positions) result.add(position);
  return result;
}

std::size_t Mesh::memory_bytes() const {
  std::size_t bytes = (positions.capacity() + normals.capacity()) * sizeof(Vec3) +
                      (tangents.capacity() + colors.capacity()) * sizeof(Vec4) +
                      triangles.capacity() * sizeof(UVec3);
  for (const auto& set : texcoords) bytes += set.capacity() * sizeof(Vec2);
  return bytes;
}

}  // namespace lume::geometry
