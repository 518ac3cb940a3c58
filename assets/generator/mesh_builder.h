// SPDX-License-Identifier: Apache-2.0
// Puts a mesh together from sheets and boxes. A builder that only counts runs the same code without
// storing anything: so a scene learns how large it would be, chooses its detail, and then reserves
// exactly the memory it needs.
#pragma once

#include "geometry/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace lume::generator {

using geometry::Mesh;
using geometry::UVec3;
using geometry::Vec2;
using geometry::Vec3;

/// A right-handed orthonormal frame that parts are placed by.
struct Placement {
  Vec3 origin{0.0f};
  std::array<Vec3, 3> axes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

  [[nodiscard]] Vec3 to_world(const Vec3& p) const {
    return origin + axes[0] * p.x + axes[1] * p.y + axes[2] * p.z;
  }
  /// The same frame, moved by an offset that is given in its own axes.
  [[nodiscard]] Placement moved(const Vec3& offset) const { return {to_world(offset), axes}; }
};

/// Turned around +y by quarters of a full turn, counter-clockwise as seen from above.
[[nodiscard]] Placement quarter_turns(const Vec3& origin, int quarters);

/// Which borders of a sheet are single points, where a quad is only one triangle.
enum class Poles { none, first_row, last_row, both };

/// A sheet's quads: `columns` in u and `rows` in v.
struct Grid {
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
  Poles poles = Poles::none;

  [[nodiscard]] bool starts_in_pole() const {
    return poles == Poles::first_row || poles == Poles::both;
  }
  [[nodiscard]] bool ends_in_pole() const {
    return poles == Poles::last_row || poles == Poles::both;
  }
  [[nodiscard]] std::size_t positions() const {
    return (std::size_t{columns} + 1) * (std::size_t{rows} + 1);
  }
  [[nodiscard]] std::size_t triangles() const {
    return 2 * std::size_t{columns} * rows - (starts_in_pole() ? columns : 0) -
           (ends_in_pole() ? columns : 0);
  }
};

class MeshBuilder {
 public:
  /// Counts what it is given.
  MeshBuilder() = default;
  /// Keeps it; the counter must have been given the same.
  [[nodiscard]] static MeshBuilder with_room_for(const MeshBuilder& counter);

  /// Where the parts to come stand.
  void place(const Placement& placement) { placement_ = placement; }
  [[nodiscard]] const Placement& placement() const { return placement_; }

  /// The surface point_at(u, v) for u and v from 0 to 1; where u goes to the right and v up, one
  /// looks at its front.
  template <class PointAt>
  void add_sheet(const Grid& grid, const PointAt& point_at) {
    position_count_ += grid.positions();
    triangle_count_ += grid.triangles();
    if (counts_) return;
    connect(grid);
    for (std::uint32_t j = 0; j <= grid.rows; ++j) {
      const float v = static_cast<float>(j) / static_cast<float>(grid.rows);
      for (std::uint32_t i = 0; i <= grid.columns; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(grid.columns);
        mesh_.positions.push_back(placement_.to_world(point_at(u, v)));
      }
    }
  }

  /// A surface of revolution around +y, seen from outside: outline_at(v) is (radius, height), in
  /// metres, and climbs on the outside.
  template <class OutlineAt>
  void add_lathe(const Grid& grid, const OutlineAt& outline_at) {
    add_sheet(grid, [&](float u, float v) {
      const Vec2 outline = outline_at(v);
      const Vec2 direction = around(u);
      return Vec3(outline.x * direction.x, outline.y, outline.x * direction.y);
    });
  }

  /// A closed box of 12 triangles.
  void add_box(const Vec3& lower, const Vec3& upper);

  [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }
  /// What was built; the builder is empty afterwards.
  [[nodiscard]] Mesh take() { return std::move(mesh_); }

  /// (x, z) on the unit circle for u of a full turn; 0 and 1 are the same point to the bit, so that
  /// seams close.
  [[nodiscard]] static Vec2 around(float u);

 private:
  /// The triangles of a sheet whose positions come next.
  void connect(const Grid& grid);

  Mesh mesh_;
  Placement placement_;
  std::size_t position_count_ = 0;
  std::size_t triangle_count_ = 0;
  bool counts_ = true;
};

}  // namespace lume::generator
