// SPDX-License-Identifier: Apache-2.0
// Which corners of a mesh's triangles share a tangent: the part of MikkTSpace that decides where
// tangents are smooth and where they break (Mikkelsen, 2008, Simulation of Wrinkled Surfaces
// Revisited, sections 4.5 and 4.6).
#pragma once

#include "geometry/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lume::io::gltf {

/// A triangle of the mesh, with its vertices welded: those of equal position, normal and texture
/// coordinates are one, the first of them.
struct TangentFace {
  static constexpr std::uint32_t k_none = ~0u;

  geometry::UVec3 vertices{0};
  /// Where the image's u grows, in the triangle's plane; of any length.
  geometry::DVec3 along_u{0.0};
  /// The image is not seen mirrored. It has v upward, as baked normal maps do; glTF's v runs down.
  bool keeps_orientation = false;
  bool fits_any = true;        ///< has no gradient of its own and joins whatever group meets it
  bool is_degenerate = false;  ///< two corners in one place
  std::array<std::uint32_t, 3> neighbours = {k_none, k_none, k_none};  ///< across corners c, c + 1
  std::array<std::uint32_t, 3> groups = {k_none, k_none, k_none};      ///< of the corners
};

using TangentFaces = std::vector<TangentFace>;

/// Corners around a vertex that are connected over edges and see the image the same way round.
struct TangentGroup {
  std::uint32_t vertex = 0;
  bool keeps_orientation = false;
  std::vector<std::pair<std::uint32_t, int>> corners;  ///< face, corner
};

/// The triangles in their order, without groups yet.
[[nodiscard]] TangentFaces make_tangent_faces(const geometry::Mesh& mesh, std::size_t set);

/// Forms the groups and enters them in the faces. A corner that no group reaches gets one that
/// stands at its vertex, or none.
[[nodiscard]] std::vector<TangentGroup> group_corners(TangentFaces& faces);

}  // namespace lume::io::gltf
