// SPDX-License-Identifier: Apache-2.0
// LUME_polygon: an outline and holes, all in one plane.
#include "io/gltf/shape_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lume::io::gltf {
namespace {

using geometry::DVec3;
using Loop = std::vector<DVec3>;

/// A ray is tested against every edge, so more would only seem to hang.
constexpr std::size_t k_max_corners = 100'000;
/// How far corners may lie off the plane, and how thin a loop may be, as parts of its size.
constexpr double k_flatness = 1e-5;
constexpr double k_thinness = 1e-10;

double diagonal(const Loop& loop) {
  geometry::DBounds bounds;
  for (const DVec3& corner : loop) {
    bounds.add(corner);
  }
  return length(bounds.size());
}

/// The area by Newell's method, which counts what is wound the other way round as negative.
double area(const Loop& loop) {
  DVec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  }
  return 0.5 * length(sum);
}

Loop read_loop(const JsonView& json, std::size_t& corners_left) {
  const std::vector<JsonView> items = json.items();
  if (items.size() < 3) {
    json.fail(fmt::format("has {} corners, expected at least 3", items.size()));
  }
  if (items.size() > corners_left) {
    json.fail(fmt::format("the polygon has more than {} corners", k_max_corners));
  }
  corners_left -= items.size();
  Loop loop;
  loop.reserve(items.size());
  for (const JsonView& item : items) {
    loop.push_back(read_point(item));
  }
  const double size = diagonal(loop);
  if (!(area(loop) > k_thinness * size * size)) {
    json.fail("spans no area: its corners lie on a line, or it crosses itself so that all cancels");
  }
  return loop;
}

void check_in_plane(const JsonView& json, const Loop& loop, const DVec3& point, const DVec3& normal,
                    double tolerance) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double height = std::abs(dot(loop[i] - point, normal));
    if (!(height <= tolerance)) {
      json.items()[i].fail(fmt::format(
          "is {:g} m off the outline's plane, expected a planar polygon (within {:g} m)", height,
          tolerance));
    }
  }
}

/// Newell's plane goes through the corners' mean.
DVec3 mean(const Loop& loop) {
  DVec3 sum(0.0);
  for (const DVec3& corner : loop) {
    sum += corner - loop[0];
  }
  return loop[0] + sum / static_cast<double>(loop.size());
}

}  // namespace

geometry::Shape read_polygon(const JsonView& parameters) {
  std::size_t corners_left = k_max_corners;
  std::vector<JsonView> sources = {parameters.require("outline")};
  for (const JsonView& hole : parameters.items("holes")) {
    sources.push_back(hole);
  }
  std::vector<Loop> loops;
  loops.reserve(sources.size());
  for (const JsonView& source : sources) {
    loops.push_back(read_loop(source, corners_left));
  }
  const DVec3 normal = geometry::Polygon::normal_of(loops[0]);
  const DVec3 middle = mean(loops[0]);
  const double tolerance = k_flatness * diagonal(loops[0]);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    check_in_plane(sources[i], loops[i], middle, normal, tolerance);
  }
  return geometry::Polygon(std::move(loops));
}

}  // namespace lume::io::gltf
