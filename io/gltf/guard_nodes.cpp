// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/guards.h"
#include "io/gltf/shape_table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace lume::io::gltf {
namespace {

/// How many there are of what a node may point to.
struct Counts {
  explicit Counts(const JsonView& root)
      : nodes(root.items("nodes").size()),
        meshes(root.items("meshes").size()),
        cameras(root.items("cameras").size()),
        skins(root.items("skins").size()),
        shapes(list_shapes(root).size()),
        materials(root.items("materials").size()) {
    if (const std::optional<JsonView> extension = root.extension("KHR_lights_punctual")) {
      lights = extension->items("lights").size();
    }
  }
  std::size_t nodes;
  std::size_t meshes;
  std::size_t cameras;
  std::size_t skins;
  std::size_t shapes;
  std::size_t materials;
  std::size_t lights = 0;
};

void check_matrix(const JsonView& matrix) {
  constexpr double k_tolerance = 1e-6;
  const std::vector<double> m = matrix.numbers(16);
  const bool affine = std::abs(m[3]) <= k_tolerance && std::abs(m[7]) <= k_tolerance &&
                      std::abs(m[11]) <= k_tolerance && std::abs(m[15] - 1.0) <= k_tolerance;
  if (!affine) {
    matrix.fail("expected an affine matrix, whose last row (elements 3, 7, 11, 15) is 0 0 0 1");
  }
}

void check_transform(const JsonView& node) {
  if (const std::optional<JsonView> matrix = node.find("matrix")) {
    check_matrix(*matrix);
  }
  static_cast<void>(node.numbers_or("translation", {0, 0, 0}, k_any));
  static_cast<void>(node.numbers_or("scale", {1, 1, 1}, k_any));
  const std::vector<double> q = node.numbers_or("rotation", {0, 0, 0, 1}, k_any);
  const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  if (!(norm > 1e-12 && norm < 1e12)) {
    node.require("rotation").fail("expected a unit quaternion");
  }
}

void check_node(const JsonView& node, const Counts& counts) {
  static_cast<void>(node.text_or("name", ""));
  check_transform(node);
  static_cast<void>(node.index_of("mesh", counts.meshes, "meshes"));
  static_cast<void>(node.index_of("camera", counts.cameras, "cameras"));
  static_cast<void>(node.index_of("skin", counts.skins, "skins"));
  static_cast<void>(find_binding(node, counts.shapes, counts.materials));
  if (const std::optional<JsonView> visibility = node.extension("KHR_node_visibility")) {
    static_cast<void>(visibility->boolean_or("visible", true));
  }
  if (const std::optional<JsonView> light = node.extension("KHR_lights_punctual")) {
    static_cast<void>(light->require("light").index(counts.lights, "lights"));
  }
}

constexpr std::size_t k_no_parent = ~std::size_t{0};

/// The parent of each node; each may have only one.
std::vector<std::size_t> check_parents(const std::vector<JsonView>& nodes) {
  std::vector<std::size_t> parents(nodes.size(), k_no_parent);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const JsonView& child : nodes[i].items("children")) {
      std::size_t& parent = parents[child.index(nodes.size(), "nodes")];
      if (parent != k_no_parent) {
        child.fail(fmt::format("node {} has two parents, nodes {} and {}, expected one",
                               child.integer(), parent, i));
      }
      parent = i;
    }
  }
  return parents;
}

/// With one parent each, nodes form trees and rings. Following the parents from a node of a ring
/// never ends; a walk marks its nodes so that no node is walked over twice.
void check_no_cycle(const std::vector<JsonView>& nodes, const std::vector<std::size_t>& parents) {
  constexpr std::size_t k_unseen = ~std::size_t{0};
  std::vector<std::size_t> seen_by(nodes.size(), k_unseen);
  for (std::size_t start = 0; start < nodes.size(); ++start) {
    std::size_t node = start;
    while (node != k_no_parent && seen_by[node] == k_unseen) {
      seen_by[node] = start;
      node = parents[node];
    }
    if (node != k_no_parent && seen_by[node] == start) {
      nodes[node].fail("is its own ancestor, expected nodes without cycles");
    }
  }
}

void check_scenes(const JsonView& root, const std::vector<std::size_t>& parents) {
  const std::vector<JsonView> scenes = root.items("scenes");
  std::vector<std::size_t> listed_by(parents.size(), scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    static_cast<void>(scenes[i].text_or("name", ""));
    for (const JsonView& reference : scenes[i].items("nodes")) {
      const std::size_t node = reference.index(parents.size(), "nodes");
      if (parents[node] != k_no_parent) {
        reference.fail(fmt::format("node {} is a child of node {}, expected a root node", node,
                                   parents[node]));
      }
      if (listed_by[node] == i) {
        reference.fail(fmt::format("node {} is listed twice", node));
      }
      listed_by[node] = i;
    }
  }
  static_cast<void>(root.index_of("scene", scenes.size(), "scenes"));
}

}  // namespace

void check_nodes(const JsonView& root) {
  const Counts counts(root);
  const std::vector<JsonView> nodes = root.items("nodes");
  for (const JsonView& node : nodes) {
    check_node(node, counts);
  }
  const std::vector<std::size_t> parents = check_parents(nodes);
  check_no_cycle(nodes, parents);
  check_scenes(root, parents);
}

}  // namespace lume::io::gltf
