// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write_lines.h"

#include "io/base64.h"
#include "io/error.h"
#include "io/write_whole_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace lume::io {
namespace {

using Json = nlohmann::ordered_json;

// Enumerations of glTF 2.0, sections 5.1.3, 5.11.5 and 5.24.4.
constexpr int k_float = 5126;
constexpr int k_array_buffer = 34962;
constexpr int k_lines = 1;

/// The document but for its buffers, and the bytes that go there.
struct Document {
  Json json;
  std::string bytes;
};

template <class Vector>
Json to_json(const Vector& v) {
  return {v.x, v.y, v.z};
}

/// Section 3.4: little-endian, as every machine that Lume runs on.
void append(std::string& bytes, const geometry::Vec3& v) {
  for (int i = 0; i < 3; ++i) {
    std::array<char, sizeof(float)> number{};
    std::memcpy(number.data(), &v[i], number.size());
    bytes.append(number.data(), number.size());
  }
}

/// The view and the accessor of a group's ends; their number is the group's.
void add_positions(Document& document, const LineGroup& group) {
  const std::size_t offset = document.bytes.size();
  geometry::Vec3 lower = group.segments.front().front();
  geometry::Vec3 upper = lower;
  for (const LineSegment& segment : group.segments) {
    for (const geometry::Vec3& end : segment) {
      lower = glm::min(lower, end);
      upper = glm::max(upper, end);
      append(document.bytes, end);
    }
  }
  Json& json = document.json;
  json["accessors"].push_back({{"bufferView", json["bufferViews"].size()},
                               {"componentType", k_float},
                               {"count", 2 * group.segments.size()},
                               {"type", "VEC3"},
                               {"min", to_json(lower)},
                               {"max", to_json(upper)}});
  json["bufferViews"].push_back({{"buffer", 0},
                                 {"byteOffset", offset},
                                 {"byteLength", document.bytes.size() - offset},
                                 {"target", k_array_buffer}});
}

Json material_to_json(const LineGroup& group) {
  const geometry::Vec3& c = group.color;
  return {{"name", group.name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {c.x, c.y, c.z, 1.0f}}, {"metallicFactor", 0.0f}}},
          {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
}

Document make_document(std::span<const LineGroup> groups, const geometry::DVec3& origin) {
  Document document;
  Json& json = document.json;
  json = {{"asset", {{"version", "2.0"}, {"generator", "Lume"}}},
          {"scene", 0},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes", {{{"name", "rays"}, {"translation", to_json(origin)}}}}};
  for (const LineGroup& group : groups) {
    if (group.segments.empty()) continue;
    const std::size_t number = json.contains("meshes") ? json["meshes"].size() : 0;
    add_positions(document, group);
    json["extensionsUsed"] = {"KHR_materials_unlit"};
    json["materials"].push_back(material_to_json(group));
    json["meshes"].push_back(
        {{"name", group.name},
         {"primitives",
          {{{"attributes", {{"POSITION", number}}}, {"material", number}, {"mode", k_lines}}}}});
    json["nodes"][0]["children"].push_back(json["nodes"].size());
    json["nodes"].push_back({{"name", group.name}, {"mesh", number}});
  }
  return document;
}

std::string dump(const Json& json) {
  // Names need not be UTF-8, JSON must be.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(Document document) {
  if (!document.bytes.empty()) {
    document.json["buffers"] = {
        {{"byteLength", document.bytes.size()},
         {"uri", "data:application/octet-stream;base64," + base64_encode(document.bytes)}}};
  }
  return dump(document.json) + "\n";
}

std::string u32(std::size_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 0xFFu);
  return bytes;
}

/// Section 4.4: the header, then chunks of a length, a type, and content padded to four bytes.
std::string to_glb(Document document) {
  if (!document.bytes.empty()) {
    document.json["buffers"] = {{{"byteLength", document.bytes.size()}}};
  }
  std::string text = dump(document.json);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string chunks = u32(text.size()) + "JSON" + text;
  if (!document.bytes.empty()) {
    // Three floats a vector: already a multiple of four.
    chunks += u32(document.bytes.size()) + std::string("BIN\0", 4) + document.bytes;
  }
  return "glTF" + u32(2) + u32(12 + chunks.size()) + chunks;
}

bool is_glb(const std::filesystem::path& path) { return path.extension() == ".glb"; }

}  // namespace

void check_lines_name(const std::filesystem::path& path) {
  if (is_glb(path) || path.extension() == ".gltf") return;
  throw Error(ErrorKind::input_output, path.string(), "",
              fmt::format("cannot be written: its extension is '{}', expected .gltf or .glb",
                          path.extension().string()));
}

void write_lines(const std::filesystem::path& path, std::span<const LineGroup> groups,
                 const geometry::DVec3& origin) {
  check_lines_name(path);
  Document document = make_document(groups, origin);
  const std::string content =
      is_glb(path) ? to_glb(std::move(document)) : to_text(std::move(document));
  write_whole_file(path, std::as_bytes(std::span(content.data(), content.size())));
}

}  // namespace lume::io
