// SPDX-License-Identifier: Apache-2.0
#include "io/check/rules.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

namespace lume::io::check {
namespace {

using gltf::Json;

/// Names of extensions that stand anywhere in the file, and where the first of each does.
void collect(const Json& value, const std::string& pointer,
             std::map<std::string, std::string>& places) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) {
      if (key == "extras") continue;
      const std::string below = fmt::format("{}/{}", pointer, key);
      if (key == "extensions" && member.is_object()) {
        for (const auto& [name, extension] : member.items()) {
          places.try_emplace(name, fmt::format("{}/{}", below, name));
        }
      }
      collect(member, below, places);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      collect(value[i], fmt::format("{}/{}", pointer, i), places);
    }
  }
}

}  // namespace

void check_extensions(const Subject& subject, Findings& findings) {
  std::map<std::string, std::string> places;
  collect(subject.document.json, "", places);
  std::set<std::string> declared;
  for (const ExtensionUse& use : subject.loaded.extensions) {
    declared.insert(use.name);
    if (use.support != Support::full) {
      findings.add(Severity::warning,
                   use.support == Support::partial ? "extension-partly" : "extension-ignored",
                   places.contains(use.name) ? places[use.name] : "/extensionsUsed",
                   fmt::format("{}: {}", use.name, use.remark),
                   "the picture is without it; docs/gltf.md lists what Lume honours");
    }
  }
  for (const auto& [name, pointer] : places) {
    if (!declared.contains(name)) {
      findings.add(Severity::warning, "extension-undeclared", pointer,
                   fmt::format("{} is not listed in extensionsUsed", name),
                   "list it: strict viewers refuse the file");
    }
  }
  for (const std::string& name : declared) {
    // These two change what other parts mean and need no object of their own.
    const bool is_silent = name == "KHR_mesh_quantization" || name == "EXT_texture_webp";
    if (!places.contains(name) && !is_silent) {
      findings.add(Severity::advice, "extension-unused", "/extensionsUsed",
                   fmt::format("{} is listed but stands nowhere", name), "take it off the list");
    }
  }
}

}  // namespace lume::io::check
