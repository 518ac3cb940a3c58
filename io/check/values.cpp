// SPDX-License-Identifier: Apache-2.0
#include "io/check/rules.h"
#include "io/gltf/accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace lume::io::check {
namespace {

using geometry::Vec3;
using gltf::JsonView;

/// Accessors whose numbers stand plainly in a buffer.
bool is_readable(const JsonView& accessor) {
  return accessor.has("bufferView") || accessor.has("sparse");
}

void check_bounds(const Subject& subject, const JsonView& accessor, std::size_t index,
                  Findings& findings) {
  if (!accessor.has("min") || !accessor.has("max")) {
    findings.add(Severity::warning, "bounds-missing", accessor.pointer(),
                 "positions without min and max, which glTF requires (section 3.7.2.1)",
                 "other viewers may cull the mesh wrongly; Lume computes its own bounds");
    return;
  }
  if (!is_readable(accessor)) return;
  // The bounds are those of the stored numbers, before they are normalized (section 3.6.2.5).
  if (accessor.boolean_or("normalized", false)) return;
  const std::vector<Vec3> positions = gltf::read_vec3(subject.document, index);
  Vec3 lower = positions.front();
  Vec3 upper = positions.front();
  for (const Vec3& position : positions) {
    lower = glm::min(lower, position);
    upper = glm::max(upper, position);
  }
  const std::vector<double> least = accessor.require("min").numbers(3);
  const std::vector<double> most = accessor.require("max").numbers(3);
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (static_cast<float>(least[i]) != lower[c] || static_cast<float>(most[i]) != upper[c]) {
      findings.add(Severity::warning, "bounds-wrong", accessor.pointer(),
                   "min and max are not those of its positions",
                   "other viewers may cull the mesh wrongly; Lume computes its own bounds");
      return;
    }
  }
}

void check_unit_vectors(const Subject& subject, const JsonView& accessor, std::size_t index,
                        Findings& findings) {
  if (!is_readable(accessor)) return;
  // Bytes are no finer than 1/127.
  const double tolerance = accessor.require("componentType").integer() == 5126 ? 0.005 : 0.02;
  for (const Vec3& normal : gltf::read_vec3(subject.document, index)) {
    if (!(std::abs(length(geometry::DVec3(normal)) - 1.0) <= tolerance)) {
      findings.add(Severity::warning, "normal-not-unit", accessor.pointer(),
                   "some of its normals are not of length 1 (section 3.7.2.1)",
                   "Lume scales them to that; export unit normals");
      return;
    }
  }
}

}  // namespace

void check_values(const Subject& subject, Findings& findings) {
  const JsonView root = subject.document.root();
  std::set<std::size_t> seen;
  for (const JsonView& mesh : root.items("meshes")) {
    for (const JsonView& primitive : mesh.items("primitives")) {
      const JsonView attributes = primitive.require("attributes");
      const auto visit = [&](const char* name, auto rule) {
        if (!attributes.has(name)) return;
        const auto index = static_cast<std::size_t>(attributes.require(name).integer());
        if (seen.insert(index).second) {
          rule(subject, root.item("accessors", index), index, findings);
        }
      };
      visit("POSITION", check_bounds);
      visit("NORMAL", check_unit_vectors);
    }
  }
}

}  // namespace lume::io::check
