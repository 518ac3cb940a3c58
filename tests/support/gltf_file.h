// SPDX-License-Identifier: Apache-2.0
// glTF files made in code, to be broken at will.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace lume::test {

inline std::string base64_encode(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* k_digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = (bits << 8) | (i + k < bytes.size() ? bytes[i + k] : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : k_digits[(bits >> (18 - 6 * k)) & 63u];
    }
  }
  return text;
}

inline void write_bytes(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
}

/// A picture of 2 x 1 texels: (255, 128, 0, 255) and (0, 64, 255, 128).
inline constexpr const char* k_png_uri =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR42mP438Dwn8HhfwMAE7oE"
    "Pq5MvUIAAAAASUVORK5CYII=";

/// A glTF file whose only buffer grows with what is added.
struct GltfFile {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::uint8_t> bytes;

  /// Appends values on a multiple of four bytes; returns their offset.
  template <class T>
  std::size_t append(const std::vector<T>& values) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t offset = bytes.size();
    bytes.resize(offset + values.size() * sizeof(T));
    if (!values.empty()) {
      std::memcpy(bytes.data() + offset, values.data(), values.size() * sizeof(T));
    }
    return offset;
  }

  template <class T>
  std::size_t add_view(const std::vector<T>& values) {
    const std::size_t offset = append(values);
    return add("bufferViews",
               {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
  }

  template <class T>
  std::size_t add_accessor(const std::vector<T>& values, int component_type,
                           const std::string& type, std::size_t components) {
    const std::size_t view = add_view(values);
    return add("accessors", {{"bufferView", view},
                             {"componentType", component_type},
                             {"count", values.size() / components},
                             {"type", type}});
  }

  std::size_t add_floats(const std::vector<float>& values, const std::string& type,
                         std::size_t components) {
    return add_accessor(values, 5126, type, components);
  }

  /// Appends to a top-level array; returns the index.
  std::size_t add(const std::string& key, const nlohmann::json& item) {
    json[key].push_back(item);
    return json[key].size() - 1;
  }

  /// The JSON with its buffer as a data URI.
  [[nodiscard]] nlohmann::json complete() const {
    nlohmann::json result = json;
    if (!bytes.empty() && !result.contains("buffers")) {
      result["buffers"] = {
          {{"byteLength", bytes.size()},
           {"uri", "data:application/octet-stream;base64," + base64_encode(bytes)}}};
    }
    return result;
  }

  /// Writes PATH as .gltf text.
  std::filesystem::path write(const std::filesystem::path& path) const {
    write_bytes(path, complete().dump());
    return path;
  }

  /// The bytes of a GLB with the buffer as its BIN chunk.
  [[nodiscard]] std::string to_glb() const {
    nlohmann::json header = json;
    header["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string text = header.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary(bytes.begin(), bytes.end());
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto u32 = [](std::size_t value) {
      std::string result;
      for (int shift = 0; shift < 32; shift += 8) {
        result += static_cast<char>((value >> shift) & 0xFFu);
      }
      return result;
    };
    return "glTF" + u32(2) + u32(12 + 8 + text.size() + 8 + binary.size()) + u32(text.size()) +
           "JSON" + text + u32(binary.size()) + std::string("BIN\0", 4) + binary;
  }
};

/// One triangle (0,0,0) (1,0,0) (0,1,0), indexed, with texture coordinates and a textured material;
/// a camera, a light, and an empty child.
inline GltfFile triangle_file() {
  GltfFile file;
  const std::size_t positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
  const std::size_t indices = file.add_accessor<std::uint16_t>({0, 1, 2}, 5123, "SCALAR", 1);
  const std::size_t texcoords = file.add_floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
  file.add("images", {{"uri", k_png_uri}});
  file.add("samplers", nlohmann::json::object());
  file.add("textures", {{"source", 0}, {"sampler", 0}});
  file.add("materials",
           {{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  file.add("meshes", {{"name", "plate"},
                      {"primitives",
                       {{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texcoords}}},
                         {"indices", indices},
                         {"material", 0}}}}});
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}});
  file.json["extensionsUsed"] = {"KHR_lights_punctual"};
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  file.add("nodes", {{"mesh", 0}, {"children", {1}}});
  file.add("nodes", {{"camera", 0}});
  file.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  file.add("scenes", {{"nodes", {0, 2}}});
  file.json["scene"] = 0;
  return file;
}

}  // namespace lume::test
