// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/cli/view_options.h"
#include "shading/scene.h"

#include <string>

namespace lume::cli {

/// True if something lights the scene: ambient or punctual light, an environment, or a surface
/// that emits all over or more than 1 nit (an emission texture up to 1 only makes parts of a model
/// glow).
[[nodiscard]] bool has_light(const shading::Scene& scene);

/// Gives the scene the environment that the options ask for, or the studio if nothing shines, so
/// that a first picture is never black. Returns what lights the scene, for the log. Throws
/// io::Error.
std::string light_scene(const ViewOptions& options, shading::Scene& scene);

}  // namespace lume::cli
