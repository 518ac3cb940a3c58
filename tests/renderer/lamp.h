// SPDX-License-Identifier: Apache-2.0
// Scenes that hold nothing but one emissive shape.
#pragma once

#include "tests/support/scenes.h"

namespace lume::test {

/// A shape that sends 1 nit in all directions, from its front only.
inline shading::Scene lamp(const geometry::Shape& shape,
                           const geometry::DMat4& transform = geometry::DMat4(1.0)) {
  shading::Scene scene;
  add_surface(scene, shape, transform).emission = shading::Color(1.0f);
  return scene;
}

/// Turns the inside of space out, and squares into slanted rhomboids.
inline geometry::DMat4 mirrored_shear() {
  geometry::DMat4 matrix(1.0);
  matrix[0] = {-2.0, 0.3, 0.1, 0.0};
  matrix[1] = {0.5, 0.6, -0.2, 0.0};
  matrix[2] = {0.2, -0.4, 1.1, 0.0};
  matrix[3] = {0.5, 1.0, -2.0, 1.0};
  return matrix;
}

}  // namespace lume::test
