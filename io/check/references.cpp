// SPDX-License-Identifier: Apache-2.0
#include "io/check/references.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace lume::io::check {
namespace {

using gltf::Json;

struct Pointing {
  std::string_view key;
  std::string_view array;
};

/// Keys whose integers are indices, wherever they stand.
constexpr auto k_pointing = std::to_array<Pointing>({
    {"buffer", "buffers"},
    {"bufferView", "bufferViews"},
    {"camera", "cameras"},
    {"children", "nodes"},
    {"indices", "accessors"},
    {"input", "accessors"},
    {"inverseBindMatrices", "accessors"},
    {"joints", "nodes"},
    {"light", "lights"},
    {"material", "materials"},
    {"mesh", "meshes"},
    {"node", "nodes"},
    {"nodes", "nodes"},
    {"output", "accessors"},
    {"skeleton", "nodes"},
    {"skin", "skins"},
    {"source", "images"},
});

constexpr std::size_t k_no_texture = std::numeric_limits<std::size_t>::max();

/// Follows a file's structure downwards; `key` names the member in which a value stands, `parent`
/// the one around that.
class Walker {
 public:
  explicit Walker(const std::string& array) : array_(array) {}

  void visit(const std::string& parent, const std::string& key, const Json& value) {
    if (key == "extras") return;
    if (value.is_object()) {
      for (const auto& [name, member] : value.items()) {
        // The attributes of Draco's extension are numbers of its own.
        if (key == "KHR_draco_mesh_compression" && name == "attributes") continue;
        visit(key, name, member);
      }
    } else if (value.is_array()) {
      for (const Json& item : value) visit(item.is_object() ? key : parent, key, item);
    } else if (value.is_number_unsigned()) {
      const std::string_view target = target_of(parent, key);
      if (!target.empty()) parts.push_back({std::string(target), value.get<std::size_t>()});
    }
  }

  std::vector<Part> parts;

 private:
  [[nodiscard]] std::string_view target_of(std::string_view parent, std::string_view key) const {
    if (parent == "attributes" || parent == "targets") return "accessors";
    if (key == "index" && parent.ends_with("Texture")) return "textures";
    if (key == "sampler") return array_ == "textures" ? "samplers" : "";
    const auto* const it =
        std::find_if(k_pointing.begin(), k_pointing.end(),
                     [&](const Pointing& pointing) { return pointing.key == key; });
    return it == k_pointing.end() ? "" : it->array;
  }

  std::string array_;
};

/// Extensions that Lume does not know have not been checked: they may hold anything.
std::size_t unsigned_or(const Json& object, const char* key, std::size_t fallback) {
  const auto it = object.find(key);
  return it != object.end() && it->is_number_unsigned() ? it->get<std::size_t>() : fallback;
}

std::size_t texcoord_of(const Json& info) {
  static const Json::json_pointer k_transform("/extensions/KHR_texture_transform");
  const std::size_t own = unsigned_or(info, "texCoord", 0);
  if (!info.contains(k_transform) || !info[k_transform].is_object()) return own;
  return unsigned_or(info[k_transform], "texCoord", own);
}

void add_texture_infos(const std::string& key, const Json& value, std::vector<TextureInfo>& infos) {
  if (!value.is_object() || key == "extras") return;
  const std::size_t texture = unsigned_or(value, "index", k_no_texture);
  if (key.ends_with("Texture") && texture != k_no_texture) {
    infos.push_back({key, texture, texcoord_of(value)});
    return;
  }
  for (const auto& [name, member] : value.items()) add_texture_infos(name, member, infos);
}

}  // namespace

std::vector<Part> references_of(const std::string& array, const Json& item) {
  Walker walker(array);
  walker.visit("", "", item);
  return walker.parts;
}

std::vector<TextureInfo> texture_infos(const Json& material) {
  std::vector<TextureInfo> infos;
  add_texture_infos("", material, infos);
  return infos;
}

}  // namespace lume::io::check
