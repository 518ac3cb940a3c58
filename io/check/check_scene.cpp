// SPDX-License-Identifier: Apache-2.0
#include "io/check/check_scene.h"

#include "io/check/rules.h"
#include "io/error.h"

namespace lume::io::check {
namespace {

/// The error as a finding. An image's error has its place in the name: "a.gltf at /images/0".
Finding to_finding(const Error& error, const std::string& file) {
  const std::string at = file + " at ";
  const bool is_part = error.path().starts_with(at);
  const std::string pointer = is_part ? error.path().substr(at.size()) : error.pointer();
  return {Severity::error, error.kind() == ErrorKind::scene ? "refused" : "unreadable", pointer,
          error.reason(), "correct this place; Lume does not draw the file as it is"};
}

}  // namespace

std::vector<Finding> check_scene(const std::filesystem::path& path) {
  Findings findings;
  try {
    const LoadedScene loaded = load_gltf(path);
    const gltf::Document document = gltf::open_document(path);
    const Subject subject{document, loaded};
    for (const auto& rule : {check_tolerated, check_extensions, check_primitives, check_values,
                             check_materials, check_lights, check_extent, check_unused}) {
      rule(subject, findings);
    }
  } catch (const Error& error) {
    // Not the file's content is wrong then, but its name.
    if (error.path() == path.string() && error.kind() == ErrorKind::input_output) throw;
    return {to_finding(error, path.string())};
  }
  return findings.sorted();
}

}  // namespace lume::io::check
