// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/gltf/json_view.h"
#include "io/gltf/notes.h"
#include "io/gltf/textures.h"
#include "shading/material.h"

#include <vector>

namespace lume::io::gltf {

/// All materials of the file, in its order; their textures are asked for in `textures`. Throws
/// Error(scene) for a value of a wrong type or out of the range that the specification gives it.
[[nodiscard]] std::vector<shading::Material> read_materials(const JsonView& root,
                                                            TextureTable& textures, Notes& notes);

}  // namespace lume::io::gltf
