// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/mesh_builder.h"

#include <cmath>

namespace lume::generator {

Placement quarter_turns(const Vec3& origin, int quarters) {
  constexpr std::array<float, 4> k_cosines = {1, 0, -1, 0};
  const float c = k_cosines[static_cast<std::size_t>(quarters & 3)];
  const float s = k_cosines[static_cast<std::size_t>((quarters + 3) & 3)];
  return {origin, {Vec3(c, 0, -s), Vec3(0, 1, 0), Vec3(s, 0, c)}};
}

MeshBuilder MeshBuilder::with_room_for(const MeshBuilder& counter) {
  MeshBuilder result;
  result.counts_ = false;
  result.mesh_.positions.reserve(counter.position_count_);
  result.mesh_.triangles.reserve(counter.triangle_count_);
  return result;
}

Vec2 MeshBuilder::around(float u) {
  const float angle = u == 1.0f ? 0.0f : 2.0f * geometry::k_pi * u;
  return {std::sin(angle), std::cos(angle)};
}

void MeshBuilder::add_box(const Vec3& lower, const Vec3& upper) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  position_count_ += 8;
  triangle_count_ += 12;
  if (counts_) return;
  for (unsigned corner = 0; corner < 8; ++corner) {
    mesh_.positions.push_back(placement_.to_world({(corner & 1u) != 0 ? upper.x : lower.x,
                                                   (corner & 2u) != 0 ? upper.y : lower.y,
                                                   (corner & 4u) != 0 ? upper.z : lower.z}));
  }
  // Corners by bits: 1 for +x, 2 for +y, 4 for +z; quads counter-clockwise from outside.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> k_faces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : k_faces) {
    mesh_.triangles.emplace_back(first + a, first + b, first + c);
    mesh_.triangles.emplace_back(first + a, first + c, first + d);
  }
}

void MeshBuilder::connect(const Grid& grid) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    const bool lower_pole = j == 0 && grid.starts_in_pole();
    const bool upper_pole = j + 1 == grid.rows && grid.ends_in_pole();
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      const std::uint32_t a = first + j * (grid.columns + 1) + i;
      const std::uint32_t d = a + grid.columns + 1;
      if (!lower_pole) mesh_.triangles.emplace_back(a, a + 1, d + 1);
      if (!upper_pole) mesh_.triangles.emplace_back(a, d + 1, d);
    }
  }
}

}  // namespace lume::generator
