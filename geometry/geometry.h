// SPDX-License-Identifier: Apache-2.0
// One surface of an object: a mesh of triangles, or a shape that is met by its formula.
#pragma once

#include "geometry/mesh.h"
#include "geometry/shapes/shape.h"

#include <variant>

namespace lume::geometry {

struct Geometry {
  std::variant<Mesh, Shape> surface;
  std::uint32_t material = 0;  ///< index into the scene's materials
  /// Some points of the surface are holes, which an accelerator must ask HoleTest about.
  bool has_holes = false;

  /// Null if the surface is of the other kind.
  [[nodiscard]] const Mesh* mesh() const { return std::get_if<Mesh>(&surface); }
  [[nodiscard]] const Shape* shape() const { return std::get_if<Shape>(&surface); }

  /// How many things an accelerator has to sort: triangles; a shape is one.
  [[nodiscard]] std::size_t primitive_count() const {
    return mesh() != nullptr ? mesh()->triangles.size() : 1;
  }
  /// In the object's space; infinite where the surface has no end.
  [[nodiscard]] Bounds bounds() const {
    return mesh() != nullptr ? mesh()->bounds() : shape_bounds(*shape(), Transform());
  }
};

}  // namespace lume::geometry
