// SPDX-License-Identifier: Apache-2.0
// Tangents for meshes that come without, as MikkTSpace makes them: what normal maps are baked with
// is what they must be read with (glTF 2.0, section 3.7.2.1).
#pragma once

#include "geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lume::io::gltf {

/// Makes mesh.tangents from its normals and its texture coordinates of `set`, both of which it must
/// have. Where triangles that share a vertex need different tangents there, the vertex is split:
/// copies with all attributes are appended, and the triangles changed. Returns of which vertex each
/// copy is one, in their order, for those who keep further values by vertex.
std::vector<std::uint32_t> generate_tangents(geometry::Mesh& mesh, std::size_t set);

}  // namespace lume::io::gltf
