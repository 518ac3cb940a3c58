// SPDX-License-Identifier: Apache-2.0
// Meshes that enclose something: whoever is inside cannot look out.
#pragma once

#include "geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace lume::renderer {

struct ClosedMesh {
  bool is_closed = false;
  bool faces_out = false;  ///< the fronts of its triangles are outside
};

/// A mesh is closed when every edge belongs to exactly two triangles that run along it in opposite
/// directions. Corners in one place are one corner: glTF repeats them where normals or texture
/// coordinates differ. Triangles without a height, as at the poles of a globe, are left out.
[[nodiscard]] ClosedMesh examine_closed(const geometry::Mesh& mesh);

}  // namespace lume::renderer
