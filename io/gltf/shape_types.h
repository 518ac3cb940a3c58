// SPDX-License-Identifier: Apache-2.0
// The kinds of analytic shapes that a glTF file may hold: those of KHR_implicit_shapes and Lume's
// own. docs/shapes.md describes them, docs/schema has the schemas of Lume's own.
#pragma once

#include "geometry/shapes/shape.h"
#include "io/gltf/json_view.h"

#include <span>
#include <string_view>

namespace lume::io::gltf {

struct ShapeType {
  std::string_view name;
  std::span<const std::string_view> properties;  ///< all that its parameters may have
  bool needs_parameters = false;  ///< false: a shape may be of this type and nothing else
  /// Makes the shape of its parameters. Throws Error(scene).
  geometry::Shape (*read)(const JsonView& parameters) = nullptr;
};

/// All that Lume can draw.
[[nodiscard]] std::span<const ShapeType> shape_types();

/// Null for a type Lume does not know.
[[nodiscard]] const ShapeType* find_shape_type(std::string_view name);

}  // namespace lume::io::gltf
