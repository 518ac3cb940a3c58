// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/animations.h"

#include "io/error.h"
#include "io/gltf/accessors.h"
#include "io/gltf/keyframes.h"
#include "io/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lume::io::gltf {
namespace {

Interpolation interpolation_of(const JsonView& sampler) {
  const std::string name = sampler.text_or("interpolation", "LINEAR");
  if (name == "STEP") {
    return Interpolation::step;
  }
  return name == "CUBICSPLINE" ? Interpolation::cubic_spline : Interpolation::linear;
}

/// Finite, not negative, and each later than the one before (glTF 2.0, section 3.11).
void check_times(const JsonView& input, const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || times[i] < 0.0) {
      input.fail(fmt::format("key {} is at {} s, expected a time of 0 or more", i, times[i]));
    }
    if (i > 0 && !(times[i] > times[i - 1])) {
      input.fail(fmt::format("key {} is at {} s, expected later than key {} at {} s", i, times[i],
                             i - 1, times[i - 1]));
    }
  }
}

Keyframes read_keyframes(const Document& document, const JsonView& sampler, bool is_rotation) {
  const std::size_t accessors = document.model.accessors.size();
  const JsonView input = sampler.require("input");
  const JsonView output = sampler.require("output");
  Keyframes keyframes;
  keyframes.interpolation = interpolation_of(sampler);
  keyframes.is_rotation = is_rotation;
  keyframes.times = read_numbers(document, input.index(accessors, "accessors"));
  check_times(input, keyframes.times);
  keyframes.values = read_numbers(document, output.index(accessors, "accessors"));
  const auto bad = std::find_if(keyframes.values.begin(), keyframes.values.end(),
                                [](double value) { return !std::isfinite(value); });
  if (bad != keyframes.values.end()) {
    output.fail(fmt::format("number {} is not finite", bad - keyframes.values.begin()));
  }
  const std::size_t rows = keyframes.interpolation == Interpolation::cubic_spline ? 3 : 1;
  keyframes.width = keyframes.values.size() / (rows * keyframes.times.size());
  return keyframes;
}

/// The node's property of that name; null for one that is not known.
std::vector<double>* property(tinygltf::Node& node, const std::string& path) {
  if (path == "translation") {
    return &node.translation;
  }
  if (path == "rotation") {
    return &node.rotation;
  }
  if (path == "scale") {
    return &node.scale;
  }
  return path == "weights" ? &node.weights : nullptr;
}

void apply_channel(Document& document, const JsonView& animation, const JsonView& channel,
                   double time, Notes& notes) {
  const JsonView target = channel.require("target");
  const auto index = target.index_of("node", document.model.nodes.size(), "nodes");
  const std::string& path = target.require("path").text();
  if (path == "pointer") {
    notes.add(target.pointer(), "KHR_animation_pointer is not played yet");
    return;
  }
  if (!index) {
    return;  // to be ignored, unless an extension says what it moves (section 3.11)
  }
  std::vector<double>* values = property(document.model.nodes[*index], path);
  if (values == nullptr) {
    notes.add(target.pointer(), fmt::format("the path '{}' is not known", path.substr(0, 60)));
    return;
  }
  const std::size_t sampler =
      channel.require("sampler").index(animation.items("samplers").size(), "samplers");
  *values = sample(
      read_keyframes(document, animation.item("samplers", sampler), path == "rotation"), time);
}

}  // namespace

std::vector<std::string> animation_names(const Document& document) {
  std::vector<std::string> names;
  for (const JsonView& animation : document.root().items("animations")) {
    const std::string name = animation.text_or("name", "");
    names.push_back(name.empty() ? fmt::format("animation {}", names.size()) : name);
  }
  return names;
}

std::optional<std::size_t> choose_animation(const Document& document,
                                            const std::optional<std::string>& wanted) {
  const std::vector<std::string> names = animation_names(document);
  if (!wanted) {
    return names.empty() ? std::nullopt : std::optional<std::size_t>(0);
  }
  const auto named = std::find(names.begin(), names.end(), *wanted);
  if (named != names.end()) {
    return static_cast<std::size_t>(named - names.begin());
  }
  std::size_t number = 0;
  const char* end = wanted->data() + wanted->size();
  const auto [rest, error] = std::from_chars(wanted->data(), end, number);
  if (error != std::errc() || rest != end || number >= names.size()) {
    throw Error(
        ErrorKind::scene, document.file, "/animations",
        fmt::format("there is no animation '{}'{}", *wanted,
                    names.empty() ? ": the file has no animations" : list_names(*wanted, names)));
  }
  return number;
}

void apply_animation(Document& document, std::size_t index, double time, Notes& notes) {
  const JsonView animation = document.root().item("animations", index);
  for (const JsonView& channel : animation.items("channels")) {
    apply_channel(document, animation, channel, time, notes);
  }
}

}  // namespace lume::io::gltf
