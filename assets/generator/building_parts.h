// SPDX-License-Identifier: Apache-2.0
// What a building is made of, each part in the builder's placement: x along the wall, y up, z out
// of the wall towards the court. Lengths are metres.
#pragma once

#include "assets/generator/mesh_builder.h"

namespace lume::generator {

/// How finely the parts are divided. All numbers are at least 1, those around something at least 3.
struct BuildingDetail {
  std::uint32_t storeys = 2;
  std::uint32_t bays_long = 3;   ///< between columns, on the long sides of the court
  std::uint32_t bays_short = 2;  ///< and on the short ones
  std::uint32_t column_around = 4;
  std::uint32_t column_rows = 1;
  std::uint32_t moulding_rows = 1;  ///< across bases, capitals, archivolts and cornices
  std::uint32_t arch_segments = 2;
  std::uint32_t balusters = 2;  ///< in each bay
  std::uint32_t baluster_around = 3;
  std::uint32_t baluster_rows = 1;
  std::uint32_t beams = 0;  ///< under the ceiling of each bay
  std::uint32_t panes = 0;  ///< of a window, along each side; 0: no windows
  std::uint32_t steps = 8;  ///< of each of the two staircases

  /// The building's detail for one number from 1 (under 1000 triangles) to some hundred (10^7).
  [[nodiscard]] static BuildingDetail of(double detail);
};

/// A fluted column on a base, with a capital, around the placement's y axis from 0 to `height`.
void add_column(MeshBuilder& builder, const BuildingDetail& detail, float height);

/// The wall above one bay from x = 0 to `width`, from the arch's springing at y = 0 to `height`,
/// `half_depth` thick to both sides of z = 0, with a moulding around the opening.
void add_arch(MeshBuilder& builder, const BuildingDetail& detail, float width, float height,
              float half_depth);

/// The balusters of one bay between columns at x = 0 and `width`, without rails.
void add_balusters(MeshBuilder& builder, const BuildingDetail& detail, float width, float height);

/// A moulding from x = 0 to `length` and y = 0 to `height` that grows out by `height`: triangles as
/// long as the wall.
void add_cornice(MeshBuilder& builder, const BuildingDetail& detail, float length, float height);

/// A window's frame and bars around x = 0 and above y = 0.
void add_window(MeshBuilder& builder, const BuildingDetail& detail, float width, float height);

/// A straight flight that climbs from (0, 0) to (run, rise), `width` deep in z, with a rail on the
/// court's side.
void add_stairs(MeshBuilder& builder, const BuildingDetail& detail, float run, float rise,
                float width);

/// A square bar of the given thickness around the line from a to b, which must not be vertical.
void add_bar(MeshBuilder& builder, const Vec3& a, const Vec3& b, float thickness);

}  // namespace lume::generator
