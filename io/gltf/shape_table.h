// SPDX-License-Identifier: Apache-2.0
// The analytic shapes of a file (KHR_implicit_shapes, or the array `shapes` of glTF 2.1), to which
// the extension LUME_shape binds nodes and mesh primitives.
#pragma once

#include "geometry/geometry.h"
#include "io/gltf/json_view.h"
#include "io/gltf/material_table.h"
#include "io/gltf/notes.h"

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace lume::io::gltf {

/// The JSON of all shapes: those of KHR_implicit_shapes if the file has that extension, else those
/// of the core array.
[[nodiscard]] std::vector<JsonView> list_shapes(const JsonView& root);

/// A shape that a node or a primitive is bound to by LUME_shape; its index is in range.
struct ShapeBinding {
  std::size_t shape = 0;
  std::optional<std::size_t> material;  ///< of a node's shape, if it has one

  friend bool operator<(const ShapeBinding& a, const ShapeBinding& b) {
    return std::tie(a.shape, a.material) < std::tie(b.shape, b.material);
  }
};

/// Nothing if the node or primitive has none. Throws Error(scene) for an index out of range.
[[nodiscard]] std::optional<ShapeBinding> find_binding(const JsonView& node_or_primitive,
                                                       std::size_t shapes, std::size_t materials);

class ShapeTable {
 public:
  /// Reads them all, used or not. A type that Lume does not know is only noted. Throws
  /// Error(scene).
  ShapeTable(const JsonView& root, Notes& notes);

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  /// The shape's name, or "shape N".
  [[nodiscard]] const std::string& name(std::size_t shape) const { return entries_[shape].name; }
  /// The shape with its material; that of a double-sided plane is a double-sided copy. Throws
  /// Error(scene) if Lume does not know its type.
  [[nodiscard]] geometry::Geometry geometry(const ShapeBinding& binding,
                                            MaterialTable& materials) const;

 private:
  struct Entry {
    JsonView json;
    std::string name;
    std::optional<geometry::Shape> shape;  ///< nothing: of an unknown type
    bool double_sided = false;
  };
  std::vector<Entry> entries_;
};

}  // namespace lume::io::gltf
