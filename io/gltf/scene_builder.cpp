// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/scene_builder.h"

#include "io/gltf/cameras.h"
#include "io/gltf/instancing.h"
#include "io/gltf/object_table.h"
#include "io/gltf/recenter.h"

#include <fmt/format.h>

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

/// Something that a node shows, before the scene's origin is known.
struct Placement {
  std::size_t node = 0;
  std::uint32_t object = 0;
  DMat4 matrix{1.0};
};

class Builder {
 public:
  Builder(const Document& document, bool tessellated, shading::Scene& scene, Notes& notes)
      : document_(document),
        json_nodes_(document.root().items("nodes")),
        tessellated_(tessellated),
        scene_(scene),
        notes_(notes),
        objects_(document, tessellated, scene, notes) {}

  void place_objects(const std::vector<PlacedNode>& nodes) {
    for (const PlacedNode& placed : nodes) {
      place_node(placed);
    }
    scene_.origin = choose_origin(bounds_);
    scene_.world.instances.reserve(placements_.size());
    for (const Placement& placement : placements_) {
      geometry::Instance& instance = scene_.world.instances.emplace_back();
      instance.name = name_of(document_.model.nodes[placement.node], placement.node);
      instance.object = placement.object;
      instance.transform = geometry::Transform(relative(placement.matrix));
    }
    placements_ = {};
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
    const std::vector<shading::PunctualLight> lights = read_lights(document_.root(), notes_);
    if (lights.empty()) {
      return;
    }
    for (const PlacedNode& placed : nodes) {
      const auto extension = json_nodes_[placed.node].extension("KHR_lights_punctual");
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

  void place_node(const PlacedNode& placed) {
    const tinygltf::Node& node = document_.model.nodes[placed.node];
    const JsonView& json = json_nodes_[placed.node];
    const std::string label = node_label(placed.node);
    std::optional<ShapeBinding> binding = objects_.binding(json);
    if (binding && tessellated_) {
      notes_.add(label, "its shape has no triangles and is left out");
      binding.reset();
    }
    if (node.mesh < 0 && !binding) {
      return;
    }
    if (!geometry::Transform::is_invertible(placed.world)) {
      notes_.add(label, "its matrix flattens space or is not finite; it is not drawn");
      return;
    }
    const InstancePlaces places(document_, json);
    if (node.mesh >= 0) {
      if (const auto object = objects_.mesh(static_cast<std::size_t>(node.mesh))) {
        place_object(placed, *object, places);
      }
    }
    if (binding) {
      place_object(placed, objects_.shape(*binding), places);
    }
    if (node.skin >= 0) {
      notes_.add(label, "its skin is not applied yet; the mesh is drawn as it was modelled");
    }
  }

  void place_object(const PlacedNode& placed, const SceneObject& object,
                    const InstancePlaces& places) {
    bool any_flat = false;
    bool any_beyond = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
      DMat4 matrix = placed.world * places.matrix(i);
      if (!geometry::Transform::is_invertible(matrix)) {
        any_flat = true;
        continue;
      }
      matrix[3] = matrix * glm::dvec4(object.shift, 1.0);
      if (!add_bounds(object.bounds, matrix)) {
        any_beyond = true;
        continue;
      }
      placements_.push_back({placed.node, object.number, matrix});
    }
    if (any_flat) {
      notes_.add(node_label(placed.node),
                 "instances whose matrix flattens space or is not finite are not drawn");
    }
    if (any_beyond) {
      notes_.add(node_label(placed.node),
                 fmt::format("what reaches beyond {:g} m is not drawn", k_farthest));
    }
  }

  /// False if the object would lie too far away. One that has no end has no bounds, and does not
  /// move the scene's origin.
  bool add_bounds(const geometry::Bounds& object, const DMat4& matrix) {
    geometry::DBounds bounds = transformed(object, matrix);
    const bool is_endless = bounds.is_empty();
    if (is_endless) {
      bounds.add(DVec3(matrix[3]));
    }
    if (!(glm::all(glm::greaterThan(bounds.lower, DVec3(-k_farthest))) &&
          glm::all(glm::lessThan(bounds.upper, DVec3(k_farthest))))) {
      return false;
    }
    if (!is_endless) {
      bounds_.add(bounds.lower);
      bounds_.add(bounds.upper);
    }
    return true;
  }

  const Document& document_;
  std::vector<JsonView> json_nodes_;
  bool tessellated_;
  shading::Scene& scene_;
  Notes& notes_;
  ObjectTable objects_;
  std::vector<Placement> placements_;
  geometry::DBounds bounds_;
};

}  // namespace

void build_scene(const Document& document, const std::vector<PlacedNode>& nodes, bool tessellated,
                 shading::Scene& scene, Notes& notes) {
  Builder builder(document, tessellated, scene, notes);
  builder.place_objects(nodes);
  builder.place_cameras(nodes);
  builder.place_lights(nodes);
}

}  // namespace lume::io::gltf
