// SPDX-License-Identifier: Apache-2.0
// A teapot after Newell's of 1975, for scenes that want many triangles in a small place.
#pragma once

#include "assets/generator/mesh_builder.h"

namespace lume::generator {

/// How wide the teapot is from the tip of its spout to its handle (metres, on x).
inline constexpr float k_teapot_width = 0.26f;

/// How the teapot's parts are divided: bodies of revolution from outlines of `rows` rows each, and
/// tubes.
struct TeapotDetail {
  std::uint32_t rows = 1;    ///< along each curve
  std::uint32_t around = 3;  ///< around the axis

  /// That of about `triangles` triangles, of which there must be 300 at least.
  [[nodiscard]] static TeapotDetail of(std::size_t triangles);
};

/// Stands on y = 0 in the builder's placement, its spout to +x.
void add_teapot(MeshBuilder& builder, const TeapotDetail& detail);

}  // namespace lume::generator
