// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshes.h"

#include "io/error.h"
#include "io/gltf/accessors.h"
#include "io/gltf/component.h"
#include "io/gltf/normals.h"
#include "io/gltf/tangents.h"
#include "io/gltf/triangulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lume::io::gltf {
namespace {

using geometry::Mesh;
using geometry::Vec2;
using geometry::Vec3;
using geometry::Vec4;

/// Accelerators square coordinates in single precision; beyond this they would overflow.
constexpr float k_farthest = 1e15f;

/// One primitive of the file and where messages say it is.
struct Source {
  const Document& document;
  const tinygltf::Primitive& primitive;
  std::string pointer;
  std::string subject;  ///< "mesh 3 primitive 0"

  [[nodiscard]] std::optional<std::size_t> attribute(const std::string& name) const {
    const auto it = primitive.attributes.find(name);
    return it == primitive.attributes.end() ? std::nullopt
                                            : std::optional(static_cast<std::size_t>(it->second));
  }
  [[nodiscard]] std::optional<std::size_t> material() const {
    return primitive.material < 0 ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(primitive.material));
  }
  [[noreturn]] void fail(const std::string& member, const std::string& reason) const {
    throw Error(ErrorKind::scene, document.file, pointer + '/' + member, reason);
  }
};

/// The first vector with a component that is not a number or larger than `limit`.
template <class V>
std::optional<std::size_t> find_unusable(const std::vector<V>& values, float limit) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    bool usable = true;
    for (int c = 0; c < V::length(); ++c) {
      usable = usable && std::abs(values[i][c]) <= limit;
    }
    if (!usable) {
      return i;
    }
  }
  return std::nullopt;
}

template <class V>
void require_usable(const Source& source, const std::string& attribute,
                    const std::vector<V>& values) {
  if (const std::optional<std::size_t> bad = find_unusable(values, k_farthest)) {
    source.fail("attributes/" + attribute,
                fmt::format("element {} is not finite or beyond {:g}", *bad, k_farthest));
  }
}

/// Each index below the number of vertices and below the largest value of its type, which would
/// restart the primitive in graphics interfaces and is not allowed (glTF 2.0, section 3.7.2.1).
void check_indices(const Source& source, const std::vector<std::uint32_t>& indices,
                   std::size_t vertices) {
  const auto accessor = static_cast<std::size_t>(source.primitive.indices);
  const auto type =
      static_cast<std::uint64_t>(source.document.model.accessors[accessor].componentType);
  const std::uint64_t restart = (std::uint64_t{1} << (8 * component_size(type))) - 1;
  const std::uint64_t limit = std::min<std::uint64_t>(vertices, restart);
  const auto bad = std::find_if(indices.begin(), indices.end(),
                                [&](std::uint32_t index) { return index >= limit; });
  if (bad != indices.end()) {
    source.fail("indices", fmt::format("index {} is {}, expected one below {}{}",
                                       bad - indices.begin(), *bad, limit,
                                       limit < vertices ? ", the primitive-restart value"
                                                        : ", the number of vertices"));
  }
}

std::vector<geometry::UVec3> read_triangles(const Source& source, std::size_t vertices,
                                            Notes& notes) {
  const auto mode = static_cast<Mode>(source.primitive.mode);
  std::size_t count = vertices;
  std::vector<geometry::UVec3> triangles;
  if (source.primitive.indices < 0) {
    triangles = triangulate(static_cast<std::uint32_t>(vertices), mode);
  } else {
    const std::vector<std::uint32_t> indices =
        read_indices(source.document, static_cast<std::size_t>(source.primitive.indices));
    check_indices(source, indices, vertices);
    count = indices.size();
    triangles = triangulate(indices, mode);
  }
  if (count < 3 || (mode == Mode::triangles && count % 3 != 0)) {
    notes.add(source.subject, "indices that do not complete a triangle are left out");
  }
  return triangles;
}

std::vector<std::vector<Vec2>> read_texcoords(const Source& source) {
  std::vector<std::vector<Vec2>> sets;
  for (const auto& [name, accessor] : source.primitive.attributes) {
    if (!name.starts_with("TEXCOORD_")) {
      continue;
    }
    const auto set = static_cast<std::size_t>(std::stoi(name.substr(9)));
    sets.resize(std::max(sets.size(), set + 1));
    sets[set] = read_vec2(source.document, static_cast<std::size_t>(accessor));
    require_usable(source, name, sets[set]);
  }
  return sets;
}

/// COLOR_0 as linear RGBA in [0, 1]; a missing alpha is 1.
std::vector<Vec4> read_colors(const Source& source) {
  const std::optional<std::size_t> accessor = source.attribute("COLOR_0");
  if (!accessor) {
    return {};
  }
  std::vector<Vec4> colors;
  if (source.document.model.accessors[*accessor].type == TINYGLTF_TYPE_VEC4) {
    colors = read_vec4(source.document, *accessor);
  } else {
    const std::vector<Vec3> rgb = read_vec3(source.document, *accessor);
    colors.reserve(rgb.size());
    for (const Vec3& color : rgb) {
      colors.emplace_back(color, 1.0f);
    }
  }
  require_usable(source, "COLOR_0", colors);
  for (Vec4& color : colors) {
    color = glm::clamp(color, Vec4(0.0f), Vec4(1.0f));
  }
  return colors;
}

/// Tangents that are missing are made where the material needs them, which may split vertices:
/// everything else must have been read before.
void read_normals_and_tangents(const Source& source, const MaterialTable& materials, Mesh& mesh,
                               Notes& notes) {
  const std::optional<std::size_t> normals = source.attribute("NORMAL");
  if (!normals) {
    // Flat facets; tangents that come without normals are to be ignored (section 3.7.2.1).
    return;
  }
  mesh.normals = read_vec3(source.document, *normals);
  if (repair_normals(mesh) > 0) {
    notes.add(source.subject, "normals without a direction are computed from the triangles");
  }
  if (const std::optional<std::size_t> tangents = source.attribute("TANGENT")) {
    mesh.tangents = read_vec4(source.document, *tangents);
    repair_tangents(mesh);
  } else if (source.material()) {
    const auto material = static_cast<std::uint32_t>(*source.material());
    const std::optional<std::uint32_t> set = materials.tangent_set(material);
    if (set && *set < mesh.texcoords.size() && !mesh.texcoords[*set].empty()) {
      generate_tangents(mesh, *set);
    }
  }
}

/// Why a primitive shows nothing; empty if it may show something.
std::string reason_to_skip(const Source& source) {
  const auto mode = static_cast<Mode>(source.primitive.mode);
  if (!source.attribute("POSITION")) {
    return "it has no POSITION and is not drawn";
  }
  if (mode == Mode::points) {
    return "points are not drawn";
  }
  return mode < Mode::triangles ? "lines are not drawn" : "";
}

void note_what_is_lost(const Source& source, Notes& notes) {
  if (!source.primitive.targets.empty()) {
    notes.add(source.subject, "morph targets are not applied yet");
  }
  if (source.attribute("COLOR_1")) {
    notes.add(source.subject, "only the first set of vertex colours is used");
  }
}

Mesh read_primitive(const Source& source, const MaterialTable& materials, Notes& notes) {
  Mesh mesh;
  mesh.positions = read_vec3(source.document, *source.attribute("POSITION"));
  require_usable(source, "POSITION", mesh.positions);
  mesh.triangles = read_triangles(source, mesh.positions.size(), notes);
  mesh.texcoords = read_texcoords(source);
  mesh.colors = read_colors(source);
  read_normals_and_tangents(source, materials, mesh, notes);
  note_what_is_lost(source, notes);
  return mesh;
}

/// The triangles of a primitive, if it has any.
std::optional<geometry::Geometry> read_triangle_surface(const Source& source,
                                                        MaterialTable& materials, Notes& notes) {
  if (const std::string reason = reason_to_skip(source); !reason.empty()) {
    notes.add(source.subject, reason);
    return std::nullopt;
  }
  Mesh mesh = read_primitive(source, materials, notes);
  if (mesh.triangles.empty()) {
    return std::nullopt;
  }
  const std::uint32_t material = materials.number(source.material());
  const bool has_holes = materials.may_have_holes(material, !mesh.colors.empty());
  return geometry::Geometry{std::move(mesh), material, has_holes};
}

}  // namespace

geometry::Object read_mesh(const Document& document, std::size_t mesh_index,
                           const ShapeTable* shapes, MaterialTable& materials, Notes& notes) {
  const tinygltf::Mesh& gltf_mesh = document.model.meshes[mesh_index];
  const JsonView json = document.root().item("meshes", mesh_index);
  geometry::Object object;
  object.name = gltf_mesh.name.empty() ? fmt::format("mesh {}", mesh_index) : gltf_mesh.name;
  for (std::size_t i = 0; i < gltf_mesh.primitives.size(); ++i) {
    const JsonView primitive = json.item("primitives", i);
    const Source source{document, gltf_mesh.primitives[i], primitive.pointer(),
                        fmt::format("mesh {} primitive {}", mesh_index, i)};
    if (shapes != nullptr) {
      if (auto binding = find_binding(primitive, shapes->size(), materials.gltf_size())) {
        binding->material = source.material();
        object.geometries.push_back(shapes->geometry(*binding, materials));
        continue;
      }
    }
    if (auto surface = read_triangle_surface(source, materials, notes)) {
      object.geometries.push_back(*std::move(surface));
    }
  }
  return object;
}

}  // namespace lume::io::gltf
