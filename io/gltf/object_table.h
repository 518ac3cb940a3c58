// SPDX-License-Identifier: Apache-2.0
// The objects of a scene. Each mesh, and each shape with a material, is one object, read when a
// node shows it first and shared by all its instances.
#pragma once

#include "io/gltf/document.h"
#include "io/gltf/material_table.h"
#include "io/gltf/notes.h"
#include "io/gltf/shape_table.h"
#include "shading/scene.h"

#include <cstddef>
#include <map>
#include <optional>

namespace lume::io::gltf {

/// An object of the file as it stands in the scene.
struct SceneObject {
  std::uint32_t number = 0;    ///< index into World::objects
  geometry::DVec3 shift{0.0};  ///< what recentring took from its positions
  geometry::Bounds bounds;     ///< around all that has an end
};

class ObjectTable {
 public:
  /// `tessellated`: primitives are their triangles, whatever shape they are bound to.
  ObjectTable(const Document& document, bool tessellated, shading::Scene& scene, Notes& notes);

  /// Nothing if the mesh has no surface. Throws Error(scene).
  [[nodiscard]] std::optional<SceneObject> mesh(std::size_t mesh);
  /// The shape a node is bound to. Throws Error(scene).
  [[nodiscard]] SceneObject shape(const ShapeBinding& binding);

  /// What the node is bound to, if it is.
  [[nodiscard]] std::optional<ShapeBinding> binding(const JsonView& node) const {
    return find_binding(node, shapes_.size(), materials_.gltf_size());
  }

 private:
  [[nodiscard]] SceneObject add(geometry::Object object);

  const Document& document_;
  bool tessellated_;
  geometry::World& world_;
  Notes& notes_;
  MaterialTable materials_;
  ShapeTable shapes_;
  std::map<std::size_t, std::optional<SceneObject>> by_mesh_;
  std::map<ShapeBinding, SceneObject> by_binding_;
};

}  // namespace lume::io::gltf
