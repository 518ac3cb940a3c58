// SPDX-License-Identifier: Apache-2.0
// glTF files with analytic shapes.
#pragma once

#include "io/gltf/load_gltf.h"
#include "tests/support/gltf_file.h"
#include "tests/support/paths.h"

#include <string>

namespace lume::test {

/// A file with these shapes and nodes, which are all roots.
inline nlohmann::json shapes_file(const nlohmann::json& shapes, const nlohmann::json& nodes) {
  return {{"asset", {{"version", "2.0"}}},
          {"extensionsUsed", {"KHR_implicit_shapes", "LUME_shape"}},
          {"extensions", {{"KHR_implicit_shapes", {{"shapes", shapes}}}}},
          {"nodes", nodes}};
}

/// A node that is bound to a shape.
inline nlohmann::json shape_node(std::size_t shape) {
  return {{"extensions", {{"LUME_shape", {{"shape", shape}}}}}};
}

/// One shape on one node.
inline nlohmann::json shape_file(const nlohmann::json& shape) {
  return shapes_file(nlohmann::json::array({shape}), nlohmann::json::array({shape_node(0)}));
}

inline nlohmann::json shape_of(const std::string& type, const nlohmann::json& parameters) {
  return {{"type", type}, {type, parameters}};
}

inline io::LoadOptions tessellated() {
  io::LoadOptions options;
  options.tessellated = true;
  return options;
}

inline io::LoadedScene load_json(const nlohmann::json& json, const io::LoadOptions& options = {}) {
  const tests::TemporaryFolder folder;
  write_bytes(folder / "a.gltf", json.dump());
  return io::load_gltf(folder / "a.gltf", options);
}

}  // namespace lume::test
