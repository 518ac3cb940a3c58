// SPDX-License-Identifier: Apache-2.0
// An opened glTF file: its JSON, tinygltf's reading of its structure, and the bytes of its buffers.
#pragma once

#include "io/gltf/glb.h"
#include "io/gltf/json_view.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace lume::io::gltf {

/// All indices, sizes and ranges in `model` have been checked; the readers rely on that.
///
/// tinygltf is given only what it reads reliably: asset, accessors, buffer views, meshes, nodes,
/// scenes, samplers and textures. It takes numbers of a wrong type for absent ones and cuts
/// integers to 32 bits, so materials, cameras, lights and images are read from `json`; and as it
/// opens any file that a URI names, buffers are loaded here.
struct Document {
  Document() = default;
  Document(Document&&) = default;
  Document& operator=(Document&&) = default;
  Document(const Document&) = delete;  // the spans below point into the vectors
  Document& operator=(const Document&) = delete;
  ~Document() = default;

  [[nodiscard]] JsonView root() const { return {json, "", file}; }
  [[nodiscard]] std::filesystem::path folder() const;
  /// The bytes of a buffer view.
  [[nodiscard]] Bytes view_bytes(std::size_t buffer_view) const;

  std::filesystem::path path;
  std::string file;  ///< the path, as messages name it
  Json json;
  tinygltf::Model model;
  /// By glTF buffer, exactly byteLength long, or empty if nobody reads it. Behind them what was
  /// compressed: `model` points there, with views and accessors that the JSON does not have.
  std::vector<Bytes> buffers;

  std::vector<std::byte> content;              ///< of the file itself
  std::vector<std::vector<std::byte>> loaded;  ///< buffers that are not in the file
};

/// Reads and checks everything but the values in buffers and images. Throws Error.
[[nodiscard]] Document open_document(const std::filesystem::path& path);

}  // namespace lume::io::gltf
