// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/shape_table.h"

#include "io/gltf/shape_types.h"
#include "io/gltf/unknown_properties.h"
#include "io/nearest_name.h"

#include <fmt/format.h>

namespace lume::io::gltf {
namespace {

[[noreturn]] void fail_unknown_type(const JsonView& type) {
  std::vector<std::string> names;
  for (const ShapeType& known : shape_types()) {
    names.emplace_back(known.name);
  }
  const std::string name = type.text().substr(0, 40);
  type.fail("there is no shape '" + name + "'" + list_names(name, names));
}

}  // namespace

std::vector<JsonView> list_shapes(const JsonView& root) {
  const std::optional<JsonView> extension = root.extension("KHR_implicit_shapes");
  return extension ? extension->require("shapes").items() : root.items("shapes");
}

std::optional<ShapeBinding> find_binding(const JsonView& node_or_primitive, std::size_t shapes,
                                         std::size_t materials) {
  const std::optional<JsonView> extension = node_or_primitive.extension("LUME_shape");
  if (!extension) {
    return std::nullopt;
  }
  return ShapeBinding{extension->require("shape").index(shapes, "shapes"),
                      extension->index_of("material", materials, "materials")};
}

ShapeTable::ShapeTable(const JsonView& root, Notes& notes) {
  if (root.extension("KHR_implicit_shapes") && root.has("shapes")) {
    notes.add("shapes", "those of KHR_implicit_shapes are used, not those of the core array");
  }
  for (const JsonView& json : list_shapes(root)) {
    const std::string label = fmt::format("shape {}", entries_.size());
    Entry& entry = entries_.emplace_back(Entry{json, json.text_or("name", label), {}, false});
    const std::string& type_name = json.require("type").text();
    const ShapeType* type = find_shape_type(type_name);
    if (type == nullptr) {
      notes.add(label, fmt::format("its type '{}' is not known to Lume", type_name.substr(0, 40)));
      continue;
    }
    const JsonView parameters =
        type->needs_parameters ? json.require(type->name) : json.find_or_empty(type->name);
    note_unknown_properties(parameters, fmt::format("'{}'", type->name), type->properties, label,
                            notes);
    entry.shape = type->read(parameters);
    entry.double_sided = type->name == "plane" && parameters.boolean_or("doubleSided", false);
  }
}

geometry::Geometry ShapeTable::geometry(const ShapeBinding& binding,
                                        MaterialTable& materials) const {
  const Entry& entry = entries_[binding.shape];
  if (!entry.shape) {
    fail_unknown_type(entry.json.require("type"));
  }
  std::uint32_t material = materials.number(binding.material);
  if (entry.double_sided) {
    material = materials.double_sided(material);
  }
  return {*entry.shape, material, materials.may_have_holes(material, false)};
}

}  // namespace lume::io::gltf
