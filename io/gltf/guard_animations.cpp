// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/component.h"
#include "io/gltf/guards.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace lume::io::gltf {
namespace {

struct Arrays {
  std::vector<JsonView> accessors;
  std::vector<JsonView> nodes;
  std::vector<JsonView> meshes;
};

const JsonView& accessor_of(const JsonView& reference, const Arrays& arrays) {
  return arrays.accessors[reference.index(arrays.accessors.size(), "accessors")];
}

bool is_float(const JsonView& accessor) {
  return static_cast<Component>(accessor.require("componentType").integer()) == Component::f32;
}

/// Rotations and weights may also be normalized integers of 8 or 16 bits (glTF 2.0, section 3.11).
bool is_fraction(const JsonView& accessor) {
  return accessor.boolean_or("normalized", false) &&
         static_cast<Component>(accessor.require("componentType").integer()) != Component::u32;
}

void check_sampler(const JsonView& sampler, const Arrays& arrays) {
  const JsonView input = sampler.require("input");
  const JsonView& times = accessor_of(input, arrays);
  if (times.require("type").text() != "SCALAR" || !is_float(times)) {
    input.fail("expected an accessor of SCALAR floats, the times of the keys");
  }
  static_cast<void>(accessor_of(sampler.require("output"), arrays));
  const std::string name = sampler.text_or("interpolation", "LINEAR");
  if (name != "LINEAR" && name != "STEP" && name != "CUBICSPLINE") {
    sampler.require("interpolation")
        .fail("is '" + name.substr(0, 20) + "', expected LINEAR, STEP or CUBICSPLINE");
  }
  if (name == "CUBICSPLINE" && times.require("count").integer() < 2) {
    input.fail("has 1 key, expected at least 2 for a CUBICSPLINE");
  }
}

/// The number of morph targets of the node's mesh.
std::size_t count_targets(const JsonView& node, const Arrays& arrays) {
  const auto mesh = node.index_of("mesh", arrays.meshes.size(), "meshes");
  if (!mesh) {
    return 0;
  }
  const std::vector<JsonView> primitives = arrays.meshes[*mesh].items("primitives");
  return primitives.empty() ? 0 : primitives.front().items("targets").size();
}

/// "VEC3" and the like that the values of a path have; empty for a path that is not known.
std::string_view type_of(std::string_view path) {
  if (path == "translation" || path == "scale") {
    return "VEC3";
  }
  if (path == "rotation") {
    return "VEC4";
  }
  return path == "weights" ? "SCALAR" : "";
}

void check_output(const JsonView& sampler, std::string_view path, std::uint64_t rows_a_key,
                  const Arrays& arrays) {
  const JsonView output = sampler.require("output");
  const JsonView& values = accessor_of(output, arrays);
  const std::string_view type = type_of(path);
  if (values.require("type").text() != type) {
    output.fail(fmt::format("is of type {}, expected {} for a {}", values.require("type").text(),
                            type, path));
  }
  const bool may_be_integer = path == "rotation" || path == "weights";
  if (!is_float(values) && !(may_be_integer && is_fraction(values))) {
    output.fail(may_be_integer ? "expected floats or normalized integers of 8 or 16 bits"
                               : "expected floats");
  }
  const bool is_spline = sampler.text_or("interpolation", "LINEAR") == "CUBICSPLINE";
  const std::uint64_t keys =
      accessor_of(sampler.require("input"), arrays).require("count").integer();
  const std::uint64_t count = values.require("count").integer();
  const std::uint64_t rows = rows_a_key * (is_spline ? 3 : 1);
  if (count % rows != 0 || count / rows != keys) {
    output.fail(fmt::format("has {} elements, expected {} for each of {} keys", count, rows, keys));
  }
}

using Channels = std::set<std::pair<std::size_t, std::string>>;

void check_channel(const JsonView& channel, const std::vector<JsonView>& samplers,
                   const Arrays& arrays, Channels& seen) {
  const std::size_t sampler = channel.require("sampler").index(samplers.size(), "samplers");
  const JsonView target = channel.require("target");
  const JsonView path = target.require("path");
  const std::string& name = path.text();
  const auto index = target.index_of("node", arrays.nodes.size(), "nodes");
  if (!index || type_of(name).empty()) {
    return;
  }
  if (!seen.emplace(*index, name).second) {
    target.fail(fmt::format("the {} of node {} has a channel already", name, *index));
  }
  const JsonView& node = arrays.nodes[*index];
  std::size_t rows_a_key = 1;
  if (name == "weights") {
    rows_a_key = count_targets(node, arrays);
    if (rows_a_key == 0) {
      path.fail(fmt::format("is weights, but node {} has no morph targets", *index));
    }
  } else if (node.has("matrix")) {
    target.require("node").fail(
        fmt::format("node {} has a matrix, expected translation, rotation and scale", *index));
  }
  check_output(samplers[sampler], name, rows_a_key, arrays);
}

}  // namespace

void check_animations(const JsonView& root) {
  const Arrays arrays{root.items("accessors"), root.items("nodes"), root.items("meshes")};
  for (const JsonView& animation : root.items("animations")) {
    static_cast<void>(animation.text_or("name", ""));
    const std::vector<JsonView> samplers = animation.items("samplers");
    for (const JsonView& sampler : samplers) {
      check_sampler(sampler, arrays);
    }
    Channels seen;
    for (const JsonView& channel : animation.items("channels")) {
      check_channel(channel, samplers, arrays, seen);
    }
  }
}

}  // namespace lume::io::gltf
