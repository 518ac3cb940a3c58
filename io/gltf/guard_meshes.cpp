// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/component.h"
#include "io/gltf/guards.h"
#include "io/gltf/shape_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace lume::io::gltf {
namespace {

/// What a primitive needs to know of the accessors and materials it points to.
struct Targets {
  struct Accessor {
    std::string type;
    Component component = Component::f32;
    bool normalized = false;
    std::uint64_t count = 0;
    bool has_view = false;
  };
  std::vector<Accessor> accessors;
  std::size_t materials = 0;
  std::size_t shapes = 0;
};

Targets collect_targets(const JsonView& root) {
  Targets targets;
  for (const JsonView& accessor : root.items("accessors")) {
    targets.accessors.push_back(
        {accessor.require("type").text(),
         static_cast<Component>(accessor.require("componentType").integer()),
         accessor.boolean_or("normalized", false), accessor.require("count").integer(),
         accessor.has("bufferView")});
  }
  targets.materials = root.items("materials").size();
  targets.shapes = list_shapes(root).size();
  return targets;
}

const Targets::Accessor& accessor_of(const JsonView& reference, const Targets& targets) {
  return targets.accessors[reference.index(targets.accessors.size(), "accessors")];
}

/// The "type"s an attribute may have; empty for attributes that are not read.
std::string_view allowed_types(std::string_view attribute) {
  if (attribute == "POSITION" || attribute == "NORMAL") {
    return "VEC3";
  }
  if (attribute == "TANGENT") {
    return "VEC4";
  }
  if (attribute == "COLOR_0") {
    return "VEC3 or VEC4";
  }
  return attribute.starts_with("TEXCOORD_") ? "VEC2" : "";
}

/// glTF 2.0, section 3.7.2.1, widened by KHR_mesh_quantization: integers are allowed up to 16 bits.
void check_attribute(const JsonView& reference, std::string_view name, const Targets& targets,
                     std::uint64_t vertices) {
  const Targets::Accessor& accessor = accessor_of(reference, targets);
  const std::string_view types = allowed_types(name);
  if (types.empty()) {
    return;
  }
  if (types.find(accessor.type) == std::string_view::npos) {
    reference.fail(fmt::format("{} is of type {}, expected {}", name, accessor.type, types));
  }
  if (accessor.component == Component::u32) {
    reference.fail(fmt::format("{} has 32-bit integers, expected floats or 8 or 16 bits", name));
  }
  if (accessor.count != vertices) {
    reference.fail(fmt::format("{} has {} elements, expected {} as POSITION has", name,
                               accessor.count, vertices));
  }
}

void check_texcoord_set(const JsonView& reference, std::string_view attribute) {
  const std::string_view set = attribute.substr(std::string_view("TEXCOORD_").size());
  const bool is_number =
      !set.empty() && set.size() <= 2 &&
      std::all_of(set.begin(), set.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!is_number || std::stoi(std::string(set)) > 15) {
    reference.fail("expected TEXCOORD_0 to TEXCOORD_15");
  }
}

void check_attributes(const JsonView& attributes, const Targets& targets) {
  const std::optional<JsonView> position = attributes.find("POSITION");
  const std::uint64_t vertices = position ? accessor_of(*position, targets).count : 0;
  for (const std::string& name : attributes.keys()) {
    const JsonView reference = attributes.require(name);
    if (name.starts_with("TEXCOORD_")) {
      check_texcoord_set(reference, name);
    }
    if (position) {
      check_attribute(reference, name, targets, vertices);
    } else {
      static_cast<void>(accessor_of(reference, targets));
    }
  }
}

/// Indices that Draco compressed need no data of their own.
void check_indices(const JsonView& indices, const Targets& targets, bool is_compressed) {
  const Targets::Accessor& accessor = accessor_of(indices, targets);
  const bool is_unsigned = accessor.component == Component::u8 ||
                           accessor.component == Component::u16 ||
                           accessor.component == Component::u32;
  if (accessor.type != "SCALAR" || !is_unsigned || accessor.normalized) {
    indices.fail("expected an accessor of unsigned integer SCALARs that are not normalized");
  }
  if (!accessor.has_view && !is_compressed) {
    indices.fail("expected an accessor with a bufferView");
  }
}

void check_primitive(const JsonView& primitive, const Targets& targets) {
  check_attributes(primitive.require("attributes"), targets);
  if (const std::optional<JsonView> indices = primitive.find("indices")) {
    check_indices(*indices, targets, primitive.extension("KHR_draco_mesh_compression").has_value());
  }
  static_cast<void>(primitive.index_of("material", targets.materials, "materials"));
  static_cast<void>(find_binding(primitive, targets.shapes, targets.materials));
  if (const std::optional<JsonView> mode = primitive.find("mode"); mode && mode->integer() > 6) {
    mode->fail(fmt::format("is {}, expected a drawing mode from 0 to 6", mode->integer()));
  }
  for (const JsonView& target : primitive.items("targets")) {
    for (const std::string& name : target.keys()) {
      static_cast<void>(accessor_of(target.require(name), targets));
    }
  }
}

}  // namespace

void check_meshes(const JsonView& root) {
  const Targets targets = collect_targets(root);
  for (const JsonView& mesh : root.items("meshes")) {
    static_cast<void>(mesh.text_or("name", ""));
    static_cast<void>(mesh.require("primitives"));
    for (const JsonView& primitive : mesh.items("primitives")) {
      check_primitive(primitive, targets);
    }
  }
}

}  // namespace lume::io::gltf
