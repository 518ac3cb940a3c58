// SPDX-License-Identifier: Apache-2.0
// The file at a time: what an animation moves is written into the document before anybody reads
// its nodes, so that no reader knows of animation.
#pragma once

#include "io/gltf/document.h"
#include "io/gltf/notes.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lume::io::gltf {

/// Every animation's name, or "animation N".
[[nodiscard]] std::vector<std::string> animation_names(const Document& document);

/// The number of the animation that is wanted, by name or number; the first if none is. Nothing if
/// none is wanted and the file has none. Throws Error(scene), naming those there are.
[[nodiscard]] std::optional<std::size_t> choose_animation(const Document& document,
                                                          const std::optional<std::string>& wanted);

/// Puts the nodes where the animation has them at `time` (seconds; before its first key and after
/// its last it stands still). Throws Error(scene) for keys in the buffers that cannot be.
void apply_animation(Document& document, std::size_t animation, double time, Notes& notes);

}  // namespace lume::io::gltf
