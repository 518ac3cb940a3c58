// SPDX-License-Identifier: Apache-2.0
#include "io/check/references.h"
#include "io/check/rules.h"

#include <fmt/format.h>

#include <algorithm>

namespace lume::io::check {
namespace {

using gltf::Json;
using gltf::JsonView;

/// What the primitive's material asks of it.
void check_texcoords(const JsonView& primitive, const JsonView& attributes, const Json& material,
                     Findings& findings) {
  for (const TextureInfo& info : texture_infos(material)) {
    const std::string name = fmt::format("TEXCOORD_{}", info.texcoord);
    if (!attributes.has(name)) {
      findings.add(
          Severity::warning, "missing-texcoord", primitive.pointer() + "/attributes",
          fmt::format("its material's {} is placed by {}, which the primitive does not have",
                      info.key, name),
          "the texture's corner colours all of it; export the texture coordinates");
    }
    const bool needs_frame = info.key == "normalTexture" || info.key == "clearcoatNormalTexture" ||
                             info.key == "anisotropyTexture";
    if (needs_frame && attributes.has("NORMAL") && !attributes.has("TANGENT")) {
      findings.add(Severity::advice, "missing-tangents", primitive.pointer() + "/attributes",
                   fmt::format("it has no TANGENT for its material's {}", info.key),
                   "tangents are computed; export those the texture was baked with if it shows "
                   "seams");
    }
  }
}

void check_primitive(const JsonView& primitive, const Json& root, Findings& findings) {
  const JsonView attributes = primitive.require("attributes");
  if (primitive.extension("LUME_shape")) return;  // what it has is for other viewers
  if (attributes.has("POSITION") && !attributes.has("NORMAL") &&
      primitive.integer_or("mode", 4) >= 4) {
    findings.add(Severity::advice, "missing-normals", primitive.pointer() + "/attributes",
                 "it has no NORMAL and shows flat facets",
                 "export normals if it is to look smooth");
  }
  if (primitive.has("material")) {
    const auto material = static_cast<std::size_t>(primitive.require("material").integer());
    check_texcoords(primitive, attributes, root["materials"][material], findings);
  }
}

/// Triangles whose corners lie on a line.
std::size_t count_degenerate(const geometry::Mesh& mesh) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    const geometry::DVec3 origin(a);
    const geometry::DVec3 normal = cross(geometry::DVec3(b) - origin, geometry::DVec3(c) - origin);
    count += normal == geometry::DVec3(0.0) ? 1 : 0;
  }
  return count;
}

void check_triangles(const geometry::World& world, Findings& findings) {
  std::size_t all = 0;
  std::size_t degenerate = 0;
  for (const geometry::Object& object : world.objects) {
    for (const geometry::Geometry& geometry : object.geometries) {
      if (const geometry::Mesh* mesh = geometry.mesh()) {
        all += mesh->triangles.size();
        degenerate += count_degenerate(*mesh);
      }
    }
  }
  if (degenerate > 0) {
    findings.add(Severity::advice, "degenerate-triangles", "",
                 fmt::format("{} of {} triangles have no area", degenerate, all),
                 "they show nothing; clean the meshes up");
  }
}

}  // namespace

void check_primitives(const Subject& subject, Findings& findings) {
  const JsonView root = subject.document.root();
  for (const JsonView& mesh : root.items("meshes")) {
    for (const JsonView& primitive : mesh.items("primitives")) {
      check_primitive(primitive, subject.document.json, findings);
    }
  }
  check_triangles(subject.loaded.scene.world, findings);
  for (const std::string& note : subject.loaded.notes) {
    if (note.starts_with("extension ")) continue;  // check_extensions() says more of it
    findings.add(Severity::warning, "not-drawn-as-written", "", note,
                 "docs/gltf.md says what Lume draws");
  }
}

}  // namespace lume::io::check
