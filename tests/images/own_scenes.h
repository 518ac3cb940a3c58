// SPDX-License-Identifier: Apache-2.0
// Pictures rendered through the libraries, of the scenes in assets/scenes and of others.
#pragma once

#include "renderer/render.h"

#include <string>
#include <string_view>
#include <vector>

namespace lume::tests {

/// The names of all scenes in assets/scenes, sorted.
[[nodiscard]] std::vector<std::string> own_scene_names();

/// `tessellated`: triangles in place of analytic shapes.
[[nodiscard]] shading::Scene load_own_scene(const std::string& name, bool tessellated = false);

/// The scene, with the studio's light if it has none.
[[nodiscard]] shading::Scene lit(shading::Scene scene);

struct Shot {
  int width = 96;
  int height = 72;
  std::uint32_t spp = 16;
  shading::PixelRegion region = {};  ///< empty: the whole picture
  std::string_view accelerator = "embree";
  std::vector<renderer::Aov> aovs = {};
  bool tessellated = false;  ///< triangles in place of analytic shapes
};

/// Renders a scene; one without lights gets the studio's.
[[nodiscard]] renderer::RenderResult render_scene(shading::Scene scene,
                                                  const geometry::Camera& camera, const Shot& shot);

/// Renders one of our own scenes by its first camera.
[[nodiscard]] renderer::RenderResult render_own_scene(const std::string& name, const Shot& shot);

}  // namespace lume::tests
