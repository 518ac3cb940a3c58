// SPDX-License-Identifier: Apache-2.0
// Small worlds to trace rays in.
#pragma once

#include "geometry/world.h"
#include "tests/support/random.h"

#include <cmath>

namespace lume::test {

/// A closed sphere of radius 1 around the origin, with normals, texture coordinates (u around, v
/// from the top pole down) and 2 * rings * rings triangles or so.
inline geometry::Mesh sphere_mesh(std::uint32_t rings) {
  using geometry::k_pi;
  geometry::Mesh mesh;
  mesh.texcoords.resize(1);
  const std::uint32_t columns = 2 * rings;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    for (std::uint32_t j = 0; j <= columns; ++j) {
      const geometry::Vec2 uv(static_cast<float>(j) / static_cast<float>(columns),
                              static_cast<float>(i) / static_cast<float>(rings));
      const bool pole = i == 0 || i == rings;
      const float radius = pole ? 0.0f : std::sin(k_pi * uv.y);
      const float angle = j == columns ? 0.0f : 2.0f * k_pi * uv.x;  // closes without a gap
      mesh.positions.emplace_back(radius * std::cos(angle), std::cos(k_pi * uv.y),
                                  -radius * std::sin(angle));
      mesh.normals.push_back(glm::normalize(mesh.positions.back()));
      mesh.texcoords[0].push_back(uv);
    }
  }
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t a = i * (columns + 1) + j;
      const std::uint32_t b = a + columns + 1;
      if (i > 0) mesh.triangles.emplace_back(a, b, a + 1);
      if (i + 1 < rings) mesh.triangles.emplace_back(a + 1, b, b + 1);
    }
  }
  return mesh;
}

/// A unit square in the plane z = 0 around the origin that faces +z, as two triangles.
inline geometry::Mesh square_mesh(float half_size = 0.5f) {
  geometry::Mesh mesh;
  const float h = half_size;
  mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  mesh.texcoords = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// `count` separate random triangles with corners in a cube.
inline geometry::Mesh triangle_soup(Random& random, std::size_t count, float half_size,
                                    float triangle_size) {
  geometry::Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const geometry::Vec3 center = random.cube(half_size);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(center + random.cube(triangle_size));
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

/// Adds an object of one surface, a mesh or a shape, and an instance of it.
template <class Surface>
void add_instance(geometry::World& world, Surface surface,
                  const geometry::DMat4& transform = geometry::DMat4(1.0)) {
  world.objects.emplace_back().geometries.push_back({std::move(surface)});
  world.instances.push_back(
      {"", static_cast<std::uint32_t>(world.objects.size() - 1), geometry::Transform(transform)});
}

/// The mesh of an object that was added as one.
inline geometry::Mesh& mesh_of(geometry::World& world, std::size_t object = 0) {
  return std::get<geometry::Mesh>(world.objects[object].geometries[0].surface);
}

/// A random affine transform: rotation, shear, scales of either sign between 1/8 and 8,
/// translation.
inline geometry::DMat4 random_transform(Random& random, float reach = 10.0f) {
  geometry::DMat4 matrix(1.0);
  do {
    for (int column = 0; column < 3; ++column) {
      const double scale = std::exp2(random.uniform(-3.0f, 3.0f));
      matrix[column] = glm::dvec4(geometry::DVec3(random.direction()) * scale, 0.0);
    }
  } while (std::abs(glm::determinant(geometry::DMat3(matrix))) <
           0.1 * length(matrix[0]) * length(matrix[1]) * length(matrix[2]));
  matrix[3] = glm::dvec4(geometry::DVec3(random.cube(reach)), 1.0);
  return matrix;
}

}  // namespace lume::test
