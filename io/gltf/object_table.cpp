// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/object_table.h"

#include "io/gltf/meshes.h"
#include "io/gltf/recenter.h"

#include <utility>

namespace lume::io::gltf {

ObjectTable::ObjectTable(const Document& document, bool tessellated, shading::Scene& scene,
                         Notes& notes)
    : document_(document),
      tessellated_(tessellated),
      world_(scene.world),
      notes_(notes),
      materials_(scene.materials),
      shapes_(document.root(), notes) {}

SceneObject ObjectTable::add(geometry::Object object) {
  const geometry::DVec3 shift(recenter(object));
  const SceneObject result{static_cast<std::uint32_t>(world_.objects.size()), shift,
                           object.bounds()};
  world_.objects.push_back(std::move(object));
  return result;
}

std::optional<SceneObject> ObjectTable::mesh(std::size_t mesh) {
  const auto [it, is_new] = by_mesh_.try_emplace(mesh);
  if (is_new) {
    geometry::Object object =
        read_mesh(document_, mesh, tessellated_ ? nullptr : &shapes_, materials_, notes_);
    if (!object.geometries.empty()) {
      it->second = add(std::move(object));
    }
  }
  return it->second;
}

SceneObject ObjectTable::shape(const ShapeBinding& binding) {
  const auto it = by_binding_.find(binding);
  if (it != by_binding_.end()) {
    return it->second;
  }
  geometry::Object object;
  object.name = shapes_.name(binding.shape);
  object.geometries.push_back(shapes_.geometry(binding, materials_));
  return by_binding_.emplace(binding, add(std::move(object))).first->second;
}

}  // namespace lume::io::gltf
