// SPDX-License-Identifier: Apache-2.0
// LUME_bezier_patch: bicubic patches that share control points by their numbers.
#include "io/gltf/shape_readers.h"

#include <fmt/format.h>

namespace lume::io::gltf {
namespace {

using geometry::BezierPatch;
using geometry::DVec3;

/// A patch is cut into as many as 256 pieces, so these are a gigabyte.
constexpr std::size_t k_max_patches = 16'384;
constexpr std::size_t k_max_points = 16 * k_max_patches;

std::vector<JsonView> some_items(const JsonView& json, std::size_t most, std::string_view things) {
  std::vector<JsonView> items = json.items();
  if (items.empty() || items.size() > most) {
    json.fail(fmt::format("has {} {}, expected 1 to {}", items.size(), things, most));
  }
  return items;
}

BezierPatch read_patch(const JsonView& json, const std::vector<DVec3>& points) {
  const std::vector<JsonView> indices = json.items();
  BezierPatch patch;
  if (indices.size() != patch.size()) {
    json.fail(fmt::format("has {} indices, expected 16", indices.size()));
  }
  bool is_point = true;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    patch[i] = points[indices[i].index(points.size(), "points")];
    is_point = is_point && patch[i] == patch[0];
  }
  if (is_point) {
    json.fail("is a single point, expected control points that are not all the same");
  }
  return patch;
}

}  // namespace

geometry::Shape read_bezier(const JsonView& parameters) {
  std::vector<DVec3> points;
  for (const JsonView& item : some_items(parameters.require("points"), k_max_points, "points")) {
    points.push_back(read_point(item));
  }
  std::vector<BezierPatch> patches;
  for (const JsonView& item : some_items(parameters.require("patches"), k_max_patches, "patches")) {
    patches.push_back(read_patch(item, points));
  }
  return geometry::BezierSurface(std::move(patches));
}

}  // namespace lume::io::gltf
