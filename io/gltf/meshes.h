// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/world.h"
#include "io/gltf/document.h"
#include "io/gltf/material_table.h"
#include "io/gltf/notes.h"
#include "io/gltf/shape_table.h"

namespace lume::io::gltf {

/// The surfaces of a glTF mesh, in its own space: triangles, and shapes that primitives are bound
/// to, unless `shapes` is null. Primitives that have neither are noted and left out. Throws
/// Error(scene) for values in the buffers that cannot be: indices beyond the vertices, positions
/// that are not finite.
[[nodiscard]] geometry::Object read_mesh(const Document& document, std::size_t mesh,
                                         const ShapeTable* shapes, MaterialTable& materials,
                                         Notes& notes);

}  // namespace lume::io::gltf
