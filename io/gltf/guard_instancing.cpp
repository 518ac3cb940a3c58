// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/component.h"
#include "io/gltf/guards.h"

#include <fmt/format.h>

namespace lume::io::gltf {
namespace {

/// The types that EXT_mesh_gpu_instancing gives its three attributes.
void check_type(const JsonView& reference, std::string_view name, const JsonView& accessor) {
  const bool is_rotation = name == "ROTATION";
  if (!is_rotation && name != "TRANSLATION" && name != "SCALE") {
    return;  // of an application's own
  }
  const std::string_view expected = is_rotation ? "VEC4" : "VEC3";
  if (accessor.require("type").text() != expected) {
    reference.fail(fmt::format("{} is of type {}, expected {}", name,
                               accessor.require("type").text(), expected));
  }
  const auto component = static_cast<Component>(accessor.require("componentType").integer());
  const bool is_integer = (component == Component::i8 || component == Component::i16) &&
                          accessor.boolean_or("normalized", false);
  if (component != Component::f32 && !(is_rotation && is_integer)) {
    reference.fail(fmt::format("{} has another component type, expected floats{}", name,
                               is_rotation ? ", or normalized bytes or shorts" : ""));
  }
}

void check_attributes(const JsonView& attributes, const std::vector<JsonView>& accessors) {
  const std::vector<std::string> names = attributes.keys();
  if (names.empty()) {
    attributes.fail("is empty, expected TRANSLATION, ROTATION or SCALE");
  }
  std::uint64_t count = 0;
  for (const std::string& name : names) {
    const JsonView reference = attributes.require(name);
    const JsonView& accessor = accessors[reference.index(accessors.size(), "accessors")];
    check_type(reference, name, accessor);
    const std::uint64_t elements = accessor.require("count").integer();
    if (name != names.front() && elements != count) {
      reference.fail(fmt::format("{} has {} elements, expected {} as {} has", name, elements, count,
                                 names.front()));
    }
    count = elements;
  }
}

}  // namespace

void check_instancing(const JsonView& root) {
  const std::vector<JsonView> accessors = root.items("accessors");
  for (const JsonView& node : root.items("nodes")) {
    if (const auto extension = node.extension("EXT_mesh_gpu_instancing")) {
      check_attributes(extension->require("attributes"), accessors);
    }
  }
}

}  // namespace lume::io::gltf
