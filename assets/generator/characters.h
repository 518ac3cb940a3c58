// SPDX-License-Identifier: Apache-2.0
// Scenes for comparing acceleration structures, in any size: four characters, each hard for a
// hierarchy in a way of its own (docs/scenes.md). The same size gives the same mesh everywhere the
// C library's sines agree.
#pragma once

#include "geometry/mesh.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace lume::generator {

// Meshes of about `triangles` triangles (within a tenth), without normals. 1,000 to 10,000,000 may
// be asked for. Metres, +y up; no triangle is without area but by rounding.

/// An open atrium of three storeys: long thin triangles beside tiny ones.
[[nodiscard]] geometry::Mesh architecture(std::size_t triangles);
/// A closed, evenly and densely divided surface on a plinth: each edge has two triangles.
[[nodiscard]] geometry::Mesh statue(std::size_t triangles);
/// A teapot of nearly all the triangles in the middle of a stadium a thousand times as wide.
[[nodiscard]] geometry::Mesh stadium(std::size_t triangles);
/// Thousands of thin, wavy, clumped strands on a ball: boxes overlap wherever they are cut.
[[nodiscard]] geometry::Mesh hair(std::size_t triangles);

/// A scene to choose by name, and where to look at it from.
struct Character {
  std::string_view name;
  std::string_view description;  ///< a few words
  geometry::Mesh (*make)(std::size_t triangles);
  geometry::Vec3 eye;       ///< metres
  geometry::Vec3 target;    ///< metres
  float vertical_fov;       ///< radians, made for pictures 3 wide and 2 high
  geometry::Vec3 to_light;  ///< the direction of the sun, of any length
};

[[nodiscard]] std::span<const Character> characters();

}  // namespace lume::generator
