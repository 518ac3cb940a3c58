// SPDX-License-Identifier: Apache-2.0
// LUME_materials_phong, which stands in three places: the course's coefficients on a material, the
// constants of attenuation on a light, ambient light and background on a scene. docs/phong.md
// describes it, docs/schema has its schemas.
#pragma once

#include "io/gltf/json_view.h"
#include "io/gltf/notes.h"
#include "shading/scene.h"

#include <cstddef>
#include <string>

namespace lume::io::gltf {

/// Gives the material its coefficients if the file has them, and with them an index of refraction
/// of at least 1. The material's other extensions have been read. Throws Error(scene).
void read_phong_material(const JsonView& json, shading::Material& material, Notes& notes);

/// Gives the light its constants if the file has them; `subject` names the light. Throws
/// Error(scene).
void read_phong_light(const JsonView& json, const std::string& subject,
                      shading::PunctualLight& light, Notes& notes);

/// Checks what all scenes of the file say and takes over what the chosen one does. Throws
/// Error(scene).
void read_phong_scenes(const JsonView& root, std::size_t chosen, shading::Scene& scene,
                       Notes& notes);

}  // namespace lume::io::gltf
