// SPDX-License-Identifier: Apache-2.0
// The builders of bounding volume hierarchies side by side, and meshes to try them on.
#pragma once

#include "geometry/accelerators/bvh/binned_sah.h"
#include "geometry/accelerators/bvh/median.h"
#include "geometry/accelerators/bvh/morton.h"
#include "geometry/accelerators/bvh/reinsertion.h"
#include "geometry/accelerators/bvh/spatial_splits.h"
#include "geometry/accelerators/bvh/sweep_sah.h"
#include "tests/support/worlds.h"

#include <string_view>
#include <utility>

namespace lume::test {

struct BvhBuilder {
  std::string_view name;
  geometry::bvh::BuildTree* build;
  bool cuts_items = false;
};

inline constexpr BvhBuilder k_bvh_builders[] = {
    {"median", geometry::bvh::build_median},
    {"binned", geometry::bvh::build_binned_sah},
    {"sweep", geometry::bvh::build_sweep_sah},
    {"lbvh", geometry::bvh::build_lbvh},
    {"reinsert", geometry::bvh::build_reinserted},
    {"spatial", geometry::bvh::build_spatial_splits, true},
};

inline geometry::Object object_of(geometry::Mesh mesh) {
  geometry::Object object;
  object.geometries.push_back({std::move(mesh)});
  return object;
}

inline void add_triangle(geometry::Mesh& mesh, const geometry::Vec3& a, const geometry::Vec3& b,
                         const geometry::Vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.emplace_back(first, first + 1, first + 2);
}

inline void add_mesh(geometry::Mesh& mesh, const geometry::Mesh& other) {
  for (std::uint32_t i = 0; i < other.triangles.size(); ++i) {
    const auto [a, b, c] = other.corners(i);
    add_triangle(mesh, a, b, c);
  }
}

/// Many small triangles and some long ones across the diagonal, whose boxes are mostly empty.
inline geometry::Mesh long_diagonals(Random& random, std::size_t count) {
  using geometry::Vec3;
  geometry::Mesh mesh = triangle_soup(random, count, 4.0f, 0.1f);
  for (std::size_t i = 0; i < count / 20; ++i) {
    const Vec3 start = random.cube(1.5f) - Vec3(2.0f);
    const Vec3 end = start + Vec3(4.0f) + random.cube(0.5f);
    add_triangle(mesh, start, end, end + random.cube(0.02f));
  }
  return mesh;
}

}  // namespace lume::test
