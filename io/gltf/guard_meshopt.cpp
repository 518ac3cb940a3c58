// SPDX-License-Identifier: Apache-2.0
// What must hold of EXT_meshopt_compression and KHR_meshopt_compression before anything is decoded
// (the extensions' section "JSON schema updates").
#include "io/gltf/meshopt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace lume::io::gltf {
namespace {

constexpr const char* k_ext = "EXT_meshopt_compression";
constexpr const char* k_khr = "KHR_meshopt_compression";

/// Beyond this no compressed view is believed (4 GiB, as for whole files).
constexpr std::uint64_t k_max_decoded = std::uint64_t{1} << 32;

MeshoptMode read_mode(const JsonView& extension) {
  const JsonView mode = extension.require("mode");
  const std::string& name = mode.text();
  if (name == "ATTRIBUTES") {
    return MeshoptMode::attributes;
  }
  if (name == "TRIANGLES") {
    return MeshoptMode::triangles;
  }
  if (name != "INDICES") {
    mode.fail("is \"" + name.substr(0, 20) + "\", expected ATTRIBUTES, TRIANGLES or INDICES");
  }
  return MeshoptMode::indices;
}

MeshoptFilter read_filter(const JsonView& extension, bool may_be_color) {
  constexpr std::array<std::pair<std::string_view, MeshoptFilter>, 5> k_filters = {
      {{"NONE", MeshoptFilter::none},
       {"OCTAHEDRAL", MeshoptFilter::octahedral},
       {"QUATERNION", MeshoptFilter::quaternion},
       {"EXPONENTIAL", MeshoptFilter::exponential},
       {"COLOR", MeshoptFilter::color}}};
  const std::string name = extension.text_or("filter", "NONE");
  const auto* const it = std::find_if(k_filters.begin(), k_filters.end(),
                                      [&](const auto& filter) { return filter.first == name; });
  if (it == k_filters.end() || (it->second == MeshoptFilter::color && !may_be_color)) {
    extension.require("filter").fail(
        fmt::format("is \"{}\", expected NONE, OCTAHEDRAL, QUATERNION{}", name.substr(0, 20),
                    may_be_color ? ", EXPONENTIAL or COLOR" : " or EXPONENTIAL"));
  }
  return it->second;
}

/// The strides that mode and filter allow, for messages; empty if `stride` is one of them.
std::string_view expected_stride(const MeshoptView& view) {
  const std::uint64_t stride = view.stride;
  if (view.mode != MeshoptMode::attributes) {
    return stride == 2 || stride == 4 ? "" : "2 or 4 for indices";
  }
  if (stride < 4 || stride > 256 || stride % 4 != 0) {
    return "a multiple of 4 in [4, 256]";
  }
  if (view.filter == MeshoptFilter::octahedral || view.filter == MeshoptFilter::color) {
    return stride == 4 || stride == 8 ? "" : "4 or 8 for its filter";
  }
  return view.filter == MeshoptFilter::quaternion && stride != 8 ? "8 for its filter" : "";
}

void check_sizes(const JsonView& extension, const JsonView& parent, const MeshoptView& view) {
  if (const std::string_view expected = expected_stride(view); !expected.empty()) {
    extension.require("byteStride").fail(fmt::format("is {}, expected {}", view.stride, expected));
  }
  if (view.mode != MeshoptMode::attributes && view.filter != MeshoptFilter::none) {
    extension.require("filter").fail("expected NONE for indices");
  }
  const JsonView count = extension.require("count");
  if (view.count < 1 || view.count > k_max_decoded / view.stride) {
    count.fail(fmt::format("is {}, expected 1 to {}", view.count, k_max_decoded / view.stride));
  }
  if (view.mode == MeshoptMode::triangles && view.count % 3 != 0) {
    count.fail(fmt::format("is {}, expected a multiple of 3 for TRIANGLES", view.count));
  }
  const JsonView length = parent.require("byteLength");
  if (length.integer() != view.count * view.stride) {
    length.fail(fmt::format("is {}, expected {}, the extension's count * byteStride",
                            length.integer(), view.count * view.stride));
  }
  if (parent.has("byteStride") && parent.require("byteStride").integer() != view.stride) {
    extension.require("byteStride")
        .fail(fmt::format("is {}, expected {} as the view has", view.stride,
                          parent.require("byteStride").integer()));
  }
}

/// The extension under either name.
std::optional<JsonView> find_extension(const JsonView& view) {
  const std::optional<JsonView> khr = view.extension(k_khr);
  std::optional<JsonView> ext = view.extension(k_ext);
  if (khr && ext) {
    khr->fail(fmt::format("expected no {} beside it", k_ext));
  }
  return khr ? khr : ext;
}

}  // namespace

std::optional<MeshoptView> find_meshopt(const JsonView& view,
                                        const std::vector<std::uint64_t>& buffer_lengths) {
  const std::optional<JsonView> extension = find_extension(view);
  if (!extension) {
    return std::nullopt;
  }
  MeshoptView result;
  result.mode = read_mode(*extension);
  result.filter = read_filter(*extension, view.extension(k_khr).has_value());
  result.buffer = extension->require("buffer").index(buffer_lengths.size(), "buffers");
  result.offset = extension->integer_or("byteOffset", 0);
  result.length = extension->require("byteLength").integer();
  result.stride = extension->require("byteStride").integer();
  result.count = extension->require("count").integer();
  const std::uint64_t limit = buffer_lengths[result.buffer];
  if (result.offset > limit || result.length > limit - result.offset) {
    extension->fail(fmt::format("its {} bytes from offset {} do not fit into buffer {} of {} bytes",
                                result.length, result.offset, result.buffer, limit));
  }
  check_sizes(*extension, view, result);
  return result;
}

std::vector<bool> find_placeholders(const JsonView& root) {
  const std::size_t count = root.items("buffers").size();
  std::vector<bool> is_parent(count, false);
  std::vector<bool> is_read(count, false);
  for (const JsonView& view : root.items("bufferViews")) {
    const std::size_t buffer = view.require("buffer").index(count, "buffers");
    if (const std::optional<JsonView> extension = find_extension(view)) {
      is_parent[buffer] = true;
      is_read[extension->require("buffer").index(count, "buffers")] = true;
    } else {
      is_read[buffer] = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    is_parent[i] = is_parent[i] && !is_read[i];
  }
  return is_parent;
}

}  // namespace lume::io::gltf
