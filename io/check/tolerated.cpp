// SPDX-License-Identifier: Apache-2.0
#include "io/check/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

namespace lume::io::check {
namespace {

using gltf::Json;
using gltf::JsonView;

/// Where an extension may stand: the pointers of such objects with N for every number.
struct Place {
  std::string_view extension;
  std::string_view owner;
};

constexpr std::string_view k_any_texture = "*Texture";

constexpr auto k_places = std::to_array<Place>({
    {"EXT_mesh_gpu_instancing", "/nodes/N"},
    {"EXT_texture_webp", "/textures/N"},
    {"KHR_animation_pointer", "/animations/N/channels/N/target"},
    {"KHR_draco_mesh_compression", "/meshes/N/primitives/N"},
    {"KHR_lights_punctual", ""},
    {"KHR_lights_punctual", "/nodes/N"},
    {"KHR_materials_variants", ""},
    {"KHR_materials_variants", "/meshes/N/primitives/N"},
    {"KHR_mesh_quantization", "nowhere"},
    {"KHR_node_visibility", "/nodes/N"},
    {"KHR_texture_basisu", "/textures/N"},
    {"KHR_texture_transform", k_any_texture},
});

bool may_stand(std::string_view extension, std::string_view owner) {
  if (extension.starts_with("KHR_materials_") && extension != "KHR_materials_variants") {
    return owner == "/materials/N";
  }
  bool is_known = false;
  for (const Place& place : k_places) {
    if (place.extension != extension) continue;
    is_known = true;
    if (place.owner == owner || (place.owner == k_any_texture && owner.ends_with("Texture"))) {
      return true;
    }
  }
  return !is_known;
}

/// Goes through everything in the file but extras.
class Walk {
 public:
  explicit Walk(Findings& findings) : findings_(findings) {}

  /// `shape` is the pointer with N for every number.
  void visit(const Json& value, const std::string& pointer, const std::string& shape) {
    if (value.is_array()) {
      if (value.empty()) {
        warn("empty-array", pointer, "an empty array, which glTF does not allow",
             "leave the member out");
      }
      for (std::size_t i = 0; i < value.size(); ++i) {
        visit(value[i], fmt::format("{}/{}", pointer, i), shape + "/N");
      }
    }
    if (!value.is_object()) return;
    for (const auto& [key, member] : value.items()) {
      if (key == "extras") continue;
      const std::string below = pointer + "/" + key;
      if (key == "extensions" && member.is_object()) {
        for (const auto& [name, extension] : member.items()) {
          if (may_stand(name, shape)) continue;
          warn("extension-misplaced", below + "/" + name,
               fmt::format("{} has no meaning here and is not read", name),
               "move it to where its specification wants it");
        }
      }
      visit(member, below, shape + "/" + key);
    }
  }

 private:
  void warn(const char* code, const std::string& pointer, const std::string& message,
            const char* advice) {
    findings_.add(Severity::warning, code, pointer, message, advice);
  }

  Findings& findings_;
};

void check_rotation(const JsonView& node, Findings& findings) {
  const std::vector<double> q = node.numbers_or("rotation", {0, 0, 0, 1}, gltf::k_any);
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (std::abs(size - 1.0) > 0.005) {
    findings.add(Severity::warning, "rotation-not-unit", node.pointer() + "/rotation",
                 "the quaternion is not of length 1",
                 "Lume scales it to that; other viewers shear");
  }
}

/// Semantics of glTF 2.0, section 3.7.2.1; all others begin with an underscore.
bool is_semantic(std::string_view name) {
  constexpr auto k_single = std::to_array<std::string_view>({"POSITION", "NORMAL", "TANGENT"});
  constexpr auto k_numbered =
      std::to_array<std::string_view>({"TEXCOORD_", "COLOR_", "JOINTS_", "WEIGHTS_"});
  const auto starts = [&](std::string_view prefix) { return name.starts_with(prefix); };
  return starts("_") || std::find(k_single.begin(), k_single.end(), name) != k_single.end() ||
         std::any_of(k_numbered.begin(), k_numbered.end(), starts);
}

void check_attributes(const JsonView& primitive, Findings& findings) {
  for (const std::string& name : primitive.require("attributes").keys()) {
    if (!is_semantic(name)) {
      findings.add(Severity::warning, "attribute-unknown", primitive.pointer() + "/attributes",
                   "'" + name + "' is no attribute of glTF and is not read",
                   "names of one's own begin with an underscore");
    }
  }
}

void check_accessor(const JsonView& accessor, Findings& findings) {
  const bool is_float = accessor.require("componentType").integer() == 5126;
  if (is_float && accessor.boolean_or("normalized", false)) {
    findings.add(Severity::warning, "accessor-normalized", accessor.pointer() + "/normalized",
                 "floats cannot be normalized", "leave \"normalized\" out");
  }
  if (accessor.has("byteOffset") && !accessor.has("bufferView") &&
      accessor.find("extensions") == std::nullopt) {
    findings.add(Severity::warning, "accessor-offset", accessor.pointer() + "/byteOffset",
                 "an offset into no buffer view", "name the bufferView or leave byteOffset out");
  }
}

void check_duplicates(const JsonView& root, const char* list, Findings& findings) {
  std::set<std::string> names;
  for (const JsonView& name : root.items(list)) {
    if (!names.insert(name.text()).second) {
      findings.add(Severity::warning, "extension-twice", name.pointer(),
                   fmt::format("'{}' is listed twice", name.text()), "list it once");
    }
  }
}

}  // namespace

void check_tolerated(const Subject& subject, Findings& findings) {
  const JsonView root = subject.document.root();
  Walk(findings).visit(subject.document.json, "", "");
  for (const JsonView& node : root.items("nodes")) check_rotation(node, findings);
  for (const JsonView& accessor : root.items("accessors")) check_accessor(accessor, findings);
  for (const JsonView& mesh : root.items("meshes")) {
    for (const JsonView& primitive : mesh.items("primitives")) {
      check_attributes(primitive, findings);
    }
  }
  check_duplicates(root, "extensionsUsed", findings);
  check_duplicates(root, "extensionsRequired", findings);
}

}  // namespace lume::io::check
