// SPDX-License-Identifier: Apache-2.0
#include "io/check/references.h"
#include "io/check/rules.h"

#include <fmt/format.h>

#include <array>
#include <set>
#include <string_view>

namespace lume::io::check {
namespace {

using gltf::Json;

/// What a person would call one item of an array.
struct Kind {
  std::string_view array;
  std::string_view singular;
};

constexpr auto k_kinds = std::to_array<Kind>({
    {"nodes", "node"},
    {"meshes", "mesh"},
    {"cameras", "camera"},
    {"skins", "skin"},
    {"materials", "material"},
    {"textures", "texture"},
    {"images", "image"},
    {"samplers", "sampler"},
    {"accessors", "accessor"},
    {"bufferViews", "buffer view"},
    {"buffers", "buffer"},
});

const Json& array_of(const Json& root, const std::string& name) {
  static const Json k_none = Json::array();
  const auto it = root.find(name);
  return it == root.end() ? k_none : *it;
}

/// Everything that can be reached from the given arrays' items.
std::set<Part> reachable(const Json& root, const std::vector<std::string>& from) {
  std::set<Part> reached;
  std::vector<Part> pending;
  for (const std::string& array : from) {
    for (std::size_t i = 0; i < array_of(root, array).size(); ++i) pending.push_back({array, i});
  }
  while (!pending.empty()) {
    const Part part = pending.back();
    pending.pop_back();
    const Json& array = array_of(root, part.array);
    if (part.index >= array.size() || !reached.insert(part).second) continue;
    for (Part& next : references_of(part.array, array[part.index])) {
      pending.push_back(std::move(next));
    }
  }
  return reached;
}

std::string size_of_views(const Json& root, const std::set<Part>& reached) {
  std::size_t bytes = 0;
  const Json& views = array_of(root, "bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!reached.contains({"bufferViews", i}))
      bytes += views[i].value("byteLength", std::size_t{0});
  }
  return fmt::format("is used by nothing ({} bytes in all)", bytes);
}

}  // namespace

void check_unused(const Subject& subject, Findings& findings) {
  const Json& root = subject.document.json;
  // A file without scenes shows all its nodes.
  const bool has_scenes = !array_of(root, "scenes").empty();
  const std::set<Part> reached = reachable(root, {has_scenes ? "scenes" : "nodes", "animations"});
  for (const Kind& kind : k_kinds) {
    const std::string array(kind.array);
    for (std::size_t i = 0; i < array_of(root, array).size(); ++i) {
      if (reached.contains({array, i})) continue;
      const std::string what =
          array == "bufferViews" ? size_of_views(root, reached) : "is used by no scene";
      findings.add(Severity::advice, "unused-data", fmt::format("/{}/{}", array, i),
                   fmt::format("this {} {}", kind.singular, what),
                   "leave it out: it costs download and loading time and shows nothing");
    }
  }
}

}  // namespace lume::io::check
