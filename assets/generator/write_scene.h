// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assets/generator/characters.h"

#include <filesystem>

namespace lume::generator {

/// Writes a .glb with the mesh in plain grey, the character's camera and its sun as a directional
/// light, under a sky that lights the shadows a little. The file appears whole or not at all.
/// Throws io::Error(input_output) if it cannot be written, or would be larger than a .glb can be (4
/// GiB).
void write_scene(const std::filesystem::path& path, const Character& character,
                 const geometry::Mesh& mesh);

}  // namespace lume::generator
