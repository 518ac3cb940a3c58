// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/scene_builder.h"

#include "io/gltf/cameras.h"
#include "io/gltf/meshes.h"
#include "io/gltf/recenter.h"

#include <fmt/format.h>

#include <map>
#include <optional>

namespace lume::io::gltf {
namespace {

using geometry::DMat4;
using geometry::DVec3;

/// Beyond this accelerators would overflow (metres).
constexpr double k_farthest = 1e15;

std::string node_label(std::size_t node) { return fmt::format("node {}", node); }

std::string name_of(const tinygltf::Node& node, std::size_t index) {
  return node.name.empty() ? node_label(index) : node.name;
}

/// A mesh of the file as it stands in the scene.
struct PlacedObject {
  std::uint32_t object = 0;
  DVec3 shift{0.0};  ///< what recentring took from its positions
  geometry::Bounds bounds;
};

/// A node's mesh before the scene's origin is known.
struct Placement {
  std::size_t node = 0;
  std::uint32_t object = 0;
  DMat4 matrix{1.0};
};

class Builder {
 public:
  Builder(const Document& document, shading::Scene& scene, Notes& notes)
      : document_(document), scene_(scene), notes_(notes) {}

  void place_meshes(const std::vector<PlacedNode>& nodes) {
    const std::size_t materials = scene_.materials.size();
    for (const PlacedNode& placed : nodes) {
      place_mesh(placed, materials);
    }
    scene_.origin = choose_origin(bounds_);
    for (const Placement& placement : placements_) {
      geometry::Instance instance;
      instance.name = name_of(document_.model.nodes[placement.node], placement.node);
      instance.object = placement.object;
      instance.transform = geometry::Transform(relative(placement.matrix));
      scene_.world.instances.push_back(std::move(instance));
    }
    add_default_material(materials);
  }

  void place_cameras(const std::vector<PlacedNode>& nodes) {
    const std::vector<geometry::Camera> cameras = read_cameras(document_.root());
    for (const PlacedNode& placed : nodes) {
      const tinygltf::Node& node = document_.model.nodes[placed.node];
      if (node.camera < 0) {
        continue;
      }
      auto camera = place(cameras[static_cast<std::size_t>(node.camera)], relative(placed.world));
      if (!camera) {
        notes_.add(node_label(placed.node), "its matrix has no viewing direction; no camera there");
        continue;
      }
      if (camera->name.empty()) {
        camera->name =
            node.name.empty() ? fmt::format("camera {}", scene_.cameras.size()) : node.name;
      }
      scene_.cameras.push_back(*std::move(camera));
    }
  }

  void place_lights(const std::vector<PlacedNode>& nodes) {
    const std::vector<shading::PunctualLight> lights = read_lights(document_.root());
    if (lights.empty()) {
      return;
    }
    const std::vector<JsonView> json = document_.root().items("nodes");
    for (const PlacedNode& placed : nodes) {
      const auto extension = json[placed.node].extension("KHR_lights_punctual");
      if (!extension) {
        continue;
      }
      const std::size_t index = extension->require("light").index(lights.size(), "lights");
      auto light = place(lights[index], relative(placed.world));
      if (!light) {
        notes_.add(node_label(placed.node), "its matrix has no direction; no light there");
        continue;
      }
      if (light->name.empty()) {
        light->name = name_of(document_.model.nodes[placed.node], placed.node);
      }
      scene_.lights.push_back(*std::move(light));
    }
  }

 private:
  /// The matrix to the scene's frame.
  [[nodiscard]] DMat4 relative(DMat4 world) const {
    world[3] -= glm::dvec4(scene_.origin, 0.0);
    return world;
  }

  void place_mesh(const PlacedNode& placed, std::size_t materials) {
    const tinygltf::Node& node = document_.model.nodes[placed.node];
    if (node.mesh < 0) {
      return;
    }
    const std::string label = node_label(placed.node);
    if (!geometry::Transform::is_invertible(placed.world)) {
      notes_.add(label, "its matrix flattens space or is not finite; its mesh is not drawn");
      return;
    }
    const std::optional<PlacedObject> object =
        object_of(static_cast<std::size_t>(node.mesh), materials);
    if (!object) {
      return;
    }
    DMat4 matrix = placed.world;
    matrix[3] = matrix * glm::dvec4(object->shift, 1.0);
    const DBounds bounds = transformed(object->bounds, matrix);
    if (!(glm::all(glm::greaterThan(bounds.lower, DVec3(-k_farthest))) &&
          glm::all(glm::lessThan(bounds.upper, DVec3(k_farthest))))) {
      notes_.add(label, fmt::format("its mesh reaches beyond {:g} m and is not drawn", k_farthest));
      return;
    }
    bounds_.add(bounds.lower);
    bounds_.add(bounds.upper);
    placements_.push_back({placed.node, object->object, matrix});
    if (node.skin >= 0) {
      notes_.add(label, "its skin is not applied yet; the mesh is drawn as it was modelled");
    }
  }

  /// Reads the mesh when it is asked for first. Nothing if it has no triangles.
  std::optional<PlacedObject> object_of(std::size_t mesh, std::size_t materials) {
    const auto [it, is_new] = objects_.try_emplace(mesh);
    if (is_new) {
      geometry::Object object =
          read_mesh(document_, mesh, std::span(scene_.materials).first(materials), notes_);
      if (!object.geometries.empty()) {
        const DVec3 shift(recenter(object));
        it->second = PlacedObject{static_cast<std::uint32_t>(scene_.world.objects.size()), shift,
                                  object.bounds()};
        scene_.world.objects.push_back(std::move(object));
      }
    }
    return it->second;
  }

  void add_default_material(std::size_t number) {
    for (const geometry::Object& object : scene_.world.objects) {
      for (const geometry::Mesh& mesh : object.geometries) {
        if (mesh.material == number) {
          scene_.materials.emplace_back().name = "default";
          return;
        }
      }
    }
  }

  const Document& document_;
  shading::Scene& scene_;
  Notes& notes_;
  std::map<std::size_t, std::optional<PlacedObject>> objects_;  ///< by glTF mesh
  std::vector<Placement> placements_;
  DBounds bounds_;
};

}  // namespace

void build_scene(const Document& document, const std::vector<PlacedNode>& nodes,
                 shading::Scene& scene, Notes& notes) {
  Builder builder(document, scene, notes);
  builder.place_meshes(nodes);
  builder.place_cameras(nodes);
  builder.place_lights(nodes);
}

}  // namespace lume::io::gltf
