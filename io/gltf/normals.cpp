// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/normals.h"

#include <cmath>

namespace lume::io::gltf {
namespace {

using geometry::DVec3;
using geometry::Vec3;
using geometry::Vec4;

/// In double, where the square of any float has room. Zero if there is no direction.
Vec3 direction_of(const Vec3& v) {
  const DVec3 wide(v);
  const double size = length(wide);
  return size > 0.0 && std::isfinite(size) ? Vec3(wide / size) : Vec3(0.0f);
}

/// Sums of the triangles' normals at each vertex, as long as the areas.
std::vector<DVec3> vertex_normals(const geometry::Mesh& mesh) {
  std::vector<DVec3> sums(mesh.positions.size(), DVec3(0.0));
  for (const geometry::UVec3& triangle : mesh.triangles) {
    const DVec3 origin(mesh.positions[triangle.x]);
    const DVec3 normal = cross(DVec3(mesh.positions[triangle.y]) - origin,
                               DVec3(mesh.positions[triangle.z]) - origin);
    for (int corner = 0; corner < 3; ++corner) {
      sums[triangle[corner]] += normal;
    }
  }
  return sums;
}

}  // namespace

std::size_t repair_normals(geometry::Mesh& mesh) {
  std::size_t replaced = 0;
  std::vector<DVec3> computed;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const Vec3 unit = direction_of(mesh.normals[i]);
    mesh.normals[i] = unit;
    if (unit == Vec3(0.0f)) {
      if (replaced++ == 0) {
        computed = vertex_normals(mesh);
      }
      const double size = length(computed[i]);
      mesh.normals[i] = size > 0.0 ? Vec3(computed[i] / size) : Vec3(0.0f, 0.0f, 1.0f);
    }
  }
  return replaced;
}

void repair_tangents(geometry::Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    const Vec4 tangent = mesh.tangents[i];
    Vec3 unit = direction_of(Vec3(tangent));
    if (unit == Vec3(0.0f)) {
      unit = geometry::make_frame(mesh.normals[i]).tangent;
    }
    mesh.tangents[i] = Vec4(unit, tangent.w < 0.0f ? -1.0f : 1.0f);
  }
}

}  // namespace lume::io::gltf
