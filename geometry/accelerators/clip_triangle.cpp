// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/clip_triangle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace lume::geometry {
namespace {

/// What is left of a triangle. Six planes leave it at most nine corners as long as it is convex;
/// the array is for the worst that rounding could make of it, a zigzag that each plane cuts at
/// every second corner.
struct Polygon {
  std::array<DVec3, 28> corners{};
  std::size_t count = 0;

  void add(const DVec3& corner) { corners[count++] = corner; }
};

/// One of the box's planes; what is beyond it is cut off.
struct Plane {
  int axis = 0;
  double place = 0.0;
  double sign = 1.0;  ///< 1: beyond is above; -1: below

  [[nodiscard]] double height(const DVec3& p) const { return sign * (p[axis] - place); }
};

bool is_beyond(const Polygon& polygon, const Plane& plane) {
  const auto* end = polygon.corners.data() + polygon.count;
  return std::any_of(polygon.corners.data(), end,
                     [&](const DVec3& corner) { return plane.height(corner) > 0.0; });
}

void cut(const Polygon& polygon, const Plane& plane, Polygon& result) {
  result.count = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const DVec3& from = polygon.corners[i];
    const DVec3& to = polygon.corners[i + 1 == polygon.count ? 0 : i + 1];
    const double height_from = plane.height(from);
    const double height_to = plane.height(to);
    if (height_from <= 0.0) result.add(from);
    if ((height_from < 0.0 && height_to > 0.0) || (height_from > 0.0 && height_to < 0.0)) {
      DVec3 crossing = from + height_from / (height_from - height_to) * (to - from);
      crossing[plane.axis] = plane.place;
      result.add(crossing);
    }
  }
}

float float_below(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) <= x
             ? nearest
             : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

Bounds outwards(const DBounds& bounds) {
  Bounds result;
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[axis] = float_below(bounds.lower[axis]);
    result.upper[axis] = -float_below(-bounds.upper[axis]);
  }
  return result;
}

}  // namespace

Bounds clip_triangle(const std::array<Vec3, 3>& corners, const Bounds& box) {
  if (box.is_empty()) return {};
  Polygon polygons[2];
  Polygon* polygon = &polygons[0];
  Polygon* spare = &polygons[1];
  Vec3 farthest(0.0f);
  for (const Vec3& corner : corners) {
    polygon->add(DVec3(corner));
    farthest = glm::max(farthest, glm::abs(corner));
  }
  // A crossing is off by some four roundings of the largest coordinate, and each of six planes may
  // cut an edge between crossings of the one before: 24 * 2^-53. With planes farther out by more
  // than that nothing is lost that is inside, and nothing with a result that is larger by it.
  constexpr double k_rounding = 1e-14;
  const DVec3 slack = k_rounding * DVec3(farthest);
  for (int axis = 0; axis < 3; ++axis) {
    for (const Plane& plane : {Plane{axis, box.lower[axis] - slack[axis], -1.0},
                               Plane{axis, box.upper[axis] + slack[axis], 1.0}}) {
      if (!is_beyond(*polygon, plane)) continue;
      cut(*polygon, plane, *spare);
      std::swap(polygon, spare);
    }
  }
  DBounds left;
  for (std::size_t i = 0; i < polygon->count; ++i) left.add(polygon->corners[i]);
  if (left.is_empty()) return {};
  left.lower = glm::max(left.lower - slack, DVec3(box.lower));
  left.upper = glm::min(left.upper + slack, DVec3(box.upper));
  return outwards(left);
}

}  // namespace lume::geometry
