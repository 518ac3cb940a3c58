// SPDX-License-Identifier: Apache-2.0
// LUME_texture_checker: a texture that is a formula. docs/phong.md describes it.
#pragma once

#include "io/gltf/json_view.h"
#include "io/gltf/notes.h"
#include "shading/texture.h"

#include <optional>
#include <string>

namespace lume::io::gltf {

/// Nothing if the texture has none. Throws Error(scene).
[[nodiscard]] std::optional<shading::Checker> find_checker(const JsonView& texture);

/// For a texture that has one; `subject` names it.
void note_unknown_checker_properties(const JsonView& texture, const std::string& subject,
                                     Notes& notes);

}  // namespace lume::io::gltf
