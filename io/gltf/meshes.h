// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/world.h"
#include "io/gltf/document.h"
#include "io/gltf/notes.h"
#include "shading/material.h"

#include <span>

namespace lume::io::gltf {

/// The triangles of a glTF mesh, in its own space. Primitives that have none are noted and left
/// out. `materials` are those of the file; primitives without one get the number materials.size().
/// Throws Error(scene) for values in the buffers that cannot be: indices beyond the vertices,
/// positions that are not finite.
[[nodiscard]] geometry::Object read_mesh(const Document& document, std::size_t mesh,
                                         std::span<const shading::Material> materials,
                                         Notes& notes);

}  // namespace lume::io::gltf
