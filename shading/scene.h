// SPDX-License-Identifier: Apache-2.0
// The immutable description of everything there is to see.
#pragma once

#include "geometry/camera.h"
#include "geometry/world.h"
#include "shading/environment.h"
#include "shading/image.h"
#include "shading/lights.h"
#include "shading/material.h"
#include "shading/texture.h"

#include <optional>
#include <vector>

namespace lume::shading {

struct Scene {
  geometry::World world;
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Material> materials;  ///< Mesh::material points here
  std::vector<PunctualLight> lights;
  std::vector<geometry::Camera> cameras;
  /// L_a, the course's ambient light: radiance (nits) that reaches every place from all around.
  Color ambient{0.0f};
  /// What rays that leave the scene see where no environment is drawn (nits). It lights nothing.
  std::optional<Color> background;
  std::optional<Environment> environment;
  /// World position of the scene frame's origin (metres). Zero for a scene around the world's own
  /// origin; one that lies far away is moved near zero, where floats are dense. All positions in
  /// this struct are relative to it: world = origin + position.
  geometry::DVec3 origin{0.0};
};

}  // namespace lume::shading
