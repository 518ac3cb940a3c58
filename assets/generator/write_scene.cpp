// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/write_scene.h"

#include "geometry/camera.h"
#include "io/error.h"
#include "io/write_whole_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lume::generator {
namespace {

using Json = nlohmann::ordered_json;
using geometry::Bounds;
using geometry::Camera;
using geometry::Mesh;
using geometry::Vec3;

// Enumerations of glTF 2.0, sections 5.1.3 and 5.11.5.
constexpr int k_float = 5126;
constexpr int k_unsigned_int = 5125;
constexpr int k_array_buffer = 34962;
constexpr int k_element_array_buffer = 34963;

Json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The rotation of a node whose -z points from `eye` to `target`, as glTF's (x, y, z, w).
Json rotation_to(const Vec3& eye, const Vec3& target) {
  const Camera camera = geometry::look_at(eye, target, 1.0f);
  const glm::quat q = glm::quat_cast(geometry::Mat3(camera.right, camera.up, camera.backward));
  return {q.x, q.y, q.z, q.w};
}

/// The mesh's two arrays, one behind the other in the buffer.
void describe_mesh(Json& json, const Mesh& mesh) {
  const Bounds bounds = mesh.bounds();
  const std::size_t position_bytes = mesh.positions.size() * sizeof(Vec3);
  const std::size_t index_bytes = mesh.triangles.size() * sizeof(geometry::UVec3);
  json["buffers"] = {{{"byteLength", position_bytes + index_bytes}}};
  json["bufferViews"] = {{{"buffer", 0},
                          {"byteOffset", 0},
                          {"byteLength", position_bytes},
                          {"target", k_array_buffer}},
                         {{"buffer", 0},
                          {"byteOffset", position_bytes},
                          {"byteLength", index_bytes},
                          {"target", k_element_array_buffer}}};
  json["accessors"] = {{{"bufferView", 0},
                        {"componentType", k_float},
                        {"count", mesh.positions.size()},
                        {"type", "VEC3"},
                        {"min", to_json(bounds.lower)},
                        {"max", to_json(bounds.upper)}},
                       {{"bufferView", 1},
                        {"componentType", k_unsigned_int},
                        {"count", 3 * mesh.triangles.size()},
                        {"type", "SCALAR"}}};
}

/// The light is in lux, the sky in nits, of a strength that needs no exposure.
Json describe(const Character& character, const Mesh& mesh) {
  Json json = {{"asset", {{"version", "2.0"}, {"generator", "lume-generate"}}},
               {"extensionsUsed", {"KHR_lights_punctual", "LUME_materials_phong"}},
               {"scene", 0}};
  json["scenes"] = {{{"nodes", {0, 1, 2}},
                     {"extensions",
                      {{"LUME_materials_phong",
                        {{"ambient", {0.22, 0.25, 0.30}}, {"background", {0.50, 0.62, 0.80}}}}}}}};
  json["nodes"] = {{{"name", character.name}, {"mesh", 0}},
                   {{"name", "camera"},
                    {"camera", 0},
                    {"translation", to_json(character.eye)},
                    {"rotation", rotation_to(character.eye, character.target)}},
                   {{"name", "sun"},
                    {"rotation", rotation_to(character.to_light, Vec3(0.0f))},
                    {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  json["cameras"] = {
      {{"type", "perspective"},
       {"perspective", {{"yfov", character.vertical_fov}, {"aspectRatio", 1.5}, {"znear", 0.01}}}}};
  json["extensions"] = {
      {"KHR_lights_punctual",
       {{"lights",
         {{{"type", "directional"}, {"intensity", 3.0}, {"color", {1.0, 0.95, 0.86}}}}}}}};
  json["materials"] = {{{"name", "grey"},
                        {"doubleSided", true},
                        {"pbrMetallicRoughness",
                         {{"baseColorFactor", {0.6, 0.6, 0.6, 1.0}},
                          {"metallicFactor", 0.0},
                          {"roughnessFactor", 0.9}}}}};
  json["meshes"] = {
      {{"name", character.name},
       {"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}};
  describe_mesh(json, mesh);
  return json;
}

/// A file in the making, of which the size is known.
class GlbBytes {
 public:
  explicit GlbBytes(std::size_t size) { bytes_.reserve(size); }

  void add(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.data(), values.size() * sizeof(T));
  }
  /// The head of a chunk (or of the file), whose second word is a length.
  void add_words(std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) add(&word, sizeof(word));
  }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace

void write_scene(const std::filesystem::path& path, const Character& character, const Mesh& mesh) {
  // Section 4.4: a header, then chunks of a length, a type, and content padded to four bytes. All
  // words are little-endian, as is every machine that Lume runs on.
  const Json json = describe(character, mesh);
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto data_size = json["buffers"][0]["byteLength"].get<std::size_t>();
  constexpr std::size_t k_heads = 12 + 8 + 8;
  const std::size_t size = k_heads + text.size() + data_size;
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw io::Error(io::ErrorKind::input_output, path.string(), "",
                    fmt::format("cannot write: {} bytes are more than a .glb can hold", size));
  }
  GlbBytes file(size);
  file.add_words({0x46546C67u, 2u, static_cast<std::uint32_t>(size)});     // "glTF"
  file.add_words({static_cast<std::uint32_t>(text.size()), 0x4E4F534Au});  // "JSON"
  file.add(text.data(), text.size());
  file.add_words({static_cast<std::uint32_t>(data_size), 0x004E4942u});  // "BIN"
  file.add(mesh.positions);
  file.add(mesh.triangles);
  io::write_whole_file(path, file.bytes());
}

}  // namespace lume::generator
