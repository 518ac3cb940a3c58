// SPDX-License-Identifier: Apache-2.0
// Cameras and lights: what the file says of them, and their place by a node's world matrix.
#pragma once

#include "geometry/camera.h"
#include "io/gltf/json_view.h"
#include "io/gltf/notes.h"
#include "shading/lights.h"

#include <optional>
#include <vector>

namespace lume::io::gltf {

/// All cameras of the file, at the origin. Throws Error(scene).
[[nodiscard]] std::vector<geometry::Camera> read_cameras(const JsonView& root);

/// All lights of KHR_lights_punctual, at the origin. Throws Error(scene).
[[nodiscard]] std::vector<shading::PunctualLight> read_lights(const JsonView& root, Notes& notes);

/// The camera at the origin of `world`, with an orthonormal frame whatever the scale of the matrix:
/// backward and up keep their sense, so that a mirrored node does not mirror the picture. Nothing
/// if the matrix has no viewing direction.
[[nodiscard]] std::optional<geometry::Camera> place(geometry::Camera camera,
                                                    const geometry::DMat4& world);

/// The light at the origin of `world`, along its -z. Nothing if that is no direction.
[[nodiscard]] std::optional<shading::PunctualLight> place(shading::PunctualLight light,
                                                          const geometry::DMat4& world);

}  // namespace lume::io::gltf
