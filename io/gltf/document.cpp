// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/document.h"

#include "io/error.h"
#include "io/gltf/draco.h"
#include "io/gltf/guards.h"
#include "io/gltf/meshopt.h"
#include "io/gltf/resources.h"

#include <fmt/format.h>

#include <exception>
#include <limits>
#include <stdexcept>

namespace lume::io::gltf {
namespace {

/// The bytes of one buffer: from its URI, or the BIN chunk for the first buffer of a GLB that has
/// none (glTF 2.0, section 4.4.3.3).
Bytes load_buffer(Document& document, const JsonView& buffer, const Chunks& chunks) {
  const auto size = static_cast<std::size_t>(buffer.require("byteLength").integer());
  const std::optional<JsonView> uri = buffer.find("uri");
  Bytes bytes;
  if (uri) {
    bytes = document.loaded.emplace_back(load_uri(*uri, document.folder()));
  } else if (document.buffers.empty() && chunks.binary) {
    bytes = *chunks.binary;
  } else {
    buffer.fail("has no \"uri\", and the file has no BIN chunk for it");
  }
  if (bytes.size() < size) {
    buffer.require("byteLength")
        .fail(fmt::format("is {}, but the buffer's data has only {} bytes", size, bytes.size()));
  }
  return bytes.first(size);
}

/// What tinygltf is to see of the JSON.
Json structure_only(const Json& json) {
  Json result = Json::object();
  for (const char* key : {"asset", "accessors", "bufferViews", "meshes", "nodes", "scene", "scenes",
                          "samplers", "textures"}) {
    if (const auto it = json.find(key); it != json.end()) {
      result[key] = *it;
    }
  }
  return result;
}

tinygltf::Model parse_structure(const Document& document) {
  tinygltf::Model model;
  std::string error;
  std::string warning;
  bool parsed = false;
  try {
    Json structure = structure_only(document.json);
    hide_compressed_indices(structure);
    const std::string text = structure.dump();
    if (text.size() > std::numeric_limits<unsigned int>::max()) {
      throw std::length_error("more than 4 GiB of JSON");
    }
    tinygltf::TinyGLTF parser;
    parsed = parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                        static_cast<unsigned int>(text.size()), "",
                                        tinygltf::REQUIRE_VERSION);
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!parsed) {
    throw Error(ErrorKind::scene, document.file, "",
                "is not valid glTF: " + error.substr(0, error.find('\n')));
  }
  return model;
}

}  // namespace

std::filesystem::path Document::folder() const {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

Bytes Document::view_bytes(std::size_t buffer_view) const {
  const tinygltf::BufferView& view = model.bufferViews[buffer_view];
  return buffers[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

Document open_document(const std::filesystem::path& path) {
  Document document;
  document.path = path;
  document.file = path.string();
  try {
    document.content = read_whole_file(path);
  } catch (const std::runtime_error& reason) {
    throw Error(ErrorKind::input_output, document.file, "", reason.what());
  }
  const Chunks chunks = split_file(document.content, document.file);
  document.json = parse_json(chunks.json, document.file);
  check_document(document.root());
  const std::vector<JsonView> buffers = document.root().items("buffers");
  const std::vector<bool> is_placeholder = find_placeholders(document.root());
  document.loaded.reserve(buffers.size());
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    document.buffers.push_back(is_placeholder[i] ? Bytes()
                                                 : load_buffer(document, buffers[i], chunks));
  }
  document.model = parse_structure(document);
  decode_meshopt_views(document);
  decode_draco_primitives(document);
  return document;
}

}  // namespace lume::io::gltf
