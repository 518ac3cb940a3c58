// SPDX-License-Identifier: Apache-2.0
// The node hierarchy of one scene, flattened: every node with its matrix to the world.
#pragma once

#include "geometry/math.h"
#include "io/gltf/document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lume::io::gltf {

struct PlacedNode {
  std::size_t node = 0;        ///< index into the file's nodes
  geometry::DMat4 world{1.0};  ///< from the node's space to the world's
};

/// The scene's nodes depth first, children in their order, without those that are hidden
/// (KHR_node_visibility).
[[nodiscard]] std::vector<PlacedNode> flatten(const Document& document,
                                              const std::vector<int>& roots);

/// Translation * rotation * scale.
[[nodiscard]] geometry::DMat4 compose(const geometry::DVec3& translation,
                                      const geometry::DMat3& rotation,
                                      const geometry::DVec3& scale);

/// The node's own matrix, in double.
[[nodiscard]] geometry::DMat4 local_matrix(const tinygltf::Node& node);

/// Every scene's name, or "scene N".
[[nodiscard]] std::vector<std::string> scene_names(const Document& document);

/// The number of the scene to load: the wanted one (by name or number), else the file's default,
/// else 0. Throws Error(scene), naming those there are.
[[nodiscard]] std::size_t choose_scene(const Document& document,
                                       const std::optional<std::string>& wanted);

/// The root nodes of a scene; of a file without scenes, all nodes that have no parent.
[[nodiscard]] std::vector<int> root_nodes(const Document& document, std::size_t scene);

}  // namespace lume::io::gltf
