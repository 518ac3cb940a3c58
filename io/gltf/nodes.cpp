// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/nodes.h"

#include "io/error.h"
#include "io/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace lume::io::gltf {
namespace {

using geometry::DMat3;
using geometry::DMat4;
using geometry::DVec3;

DVec3 to_vector(const std::vector<double>& numbers, double fallback) {
  return numbers.size() == 3 ? DVec3(numbers[0], numbers[1], numbers[2]) : DVec3(fallback);
}

/// The whole text as a number.
std::optional<std::size_t> parse_number(const std::string& text) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

[[noreturn]] void fail_unknown_scene(const Document& document, const std::string& wanted,
                                     const std::vector<std::string>& names) {
  throw Error(ErrorKind::scene, document.file, "/scenes",
              fmt::format("there is no scene '{}'{}", wanted,
                          names.empty() ? ": the file has no scenes" : list_names(wanted, names)));
}

/// KHR_node_visibility: neither the node nor what is below it is shown.
bool is_hidden(const JsonView& node) {
  const std::optional<JsonView> visibility = node.extension("KHR_node_visibility");
  return visibility && !visibility->boolean_or("visible", true);
}

}  // namespace

DMat4 compose(const DVec3& translation, const DMat3& rotation, const DVec3& scale) {
  return {{rotation[0] * scale.x, 0.0},
          {rotation[1] * scale.y, 0.0},
          {rotation[2] * scale.z, 0.0},
          {translation, 1.0}};
}

DMat4 local_matrix(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    DMat4 matrix;
    for (int i = 0; i < 16; ++i) {
      matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    }
    for (int column = 0; column < 4; ++column) {
      matrix[column][3] = column == 3 ? 1.0 : 0.0;  // exactly affine, not just nearly
    }
    return matrix;
  }
  DMat3 rotation(1.0);
  if (node.rotation.size() == 4) {
    const std::vector<double>& q = node.rotation;  // x, y, z, w
    rotation = glm::mat3_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])));
  }
  return compose(to_vector(node.translation, 0.0), rotation, to_vector(node.scale, 1.0));
}

std::vector<PlacedNode> flatten(const Document& document, const std::vector<int>& roots) {
  const std::vector<JsonView> json_nodes = document.root().items("nodes");
  std::vector<PlacedNode> result;
  // A stack of our own: a file may chain a million nodes. Each entry holds the parent's matrix.
  std::vector<PlacedNode> pending;
  const auto push = [&](const std::vector<int>& nodes, const DMat4& parent) {
    std::for_each(nodes.rbegin(), nodes.rend(), [&](int node) {
      pending.push_back({static_cast<std::size_t>(node), parent});
    });
  };
  push(roots, DMat4(1.0));
  while (!pending.empty()) {
    PlacedNode placed = pending.back();
    pending.pop_back();
    if (is_hidden(json_nodes[placed.node])) {
      continue;
    }
    const tinygltf::Node& node = document.model.nodes[placed.node];
    placed.world = placed.world * local_matrix(node);
    push(node.children, placed.world);
    result.push_back(placed);
  }
  return result;
}

std::vector<std::string> scene_names(const Document& document) {
  std::vector<std::string> names;
  for (const tinygltf::Scene& scene : document.model.scenes) {
    names.push_back(scene.name.empty() ? fmt::format("scene {}", names.size()) : scene.name);
  }
  return names;
}

std::size_t choose_scene(const Document& document, const std::optional<std::string>& wanted) {
  const std::vector<std::string> names = scene_names(document);
  if (!wanted) {
    return static_cast<std::size_t>(std::max(document.model.defaultScene, 0));
  }
  const auto named = std::find(names.begin(), names.end(), *wanted);
  if (named != names.end()) {
    return static_cast<std::size_t>(named - names.begin());
  }
  const std::optional<std::size_t> number = parse_number(*wanted);
  if (!number || *number >= names.size()) {
    fail_unknown_scene(document, *wanted, names);
  }
  return *number;
}

std::vector<int> root_nodes(const Document& document, std::size_t scene) {
  if (!document.model.scenes.empty()) {
    return document.model.scenes[scene].nodes;
  }
  std::vector<bool> is_child(document.model.nodes.size(), false);
  for (const tinygltf::Node& node : document.model.nodes) {
    for (const int child : node.children) {
      is_child[static_cast<std::size_t>(child)] = true;
    }
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) {
      roots.push_back(static_cast<int>(i));
    }
  }
  return roots;
}

}  // namespace lume::io::gltf
