// SPDX-License-Identifier: Apache-2.0
// The plane n.x = d, and what is cut from it: a rectangle, and a disk.
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/round.h"
#include "geometry/shapes/shape_point.h"

#include <cmath>
#include <limits>
#include <optional>

namespace lume::geometry {

/// t where the ray meets the plane n.x = d: t = (d - n.o) / n.D. Nothing for a ray that runs
/// parallel to it (n.D = 0), in it or beside it, and nothing outside the ray.
[[nodiscard]] inline std::optional<double> intersect_plane(const ObjectRay& ray, const DVec3& n,
                                                           double d) {
  const double approach = dot(n, ray.direction);
  const double t = (d - dot(n, ray.origin)) / approach;
  if (approach == 0.0 || !ray.contains(t)) return std::nullopt;
  return t;
}

/// The same for y = 0, where n = (0, 1, 0) and d = 0.
[[nodiscard]] inline std::optional<double> intersect_ground(const ObjectRay& ray) {
  const double t = -ray.origin.y / ray.direction.y;
  if (ray.direction.y == 0.0 || !ray.contains(t)) return std::nullopt;
  return t;
}

/// The plane y = 0, facing +y, as far as its sizes go.
struct Plane {
  double size_x = std::numeric_limits<double>::infinity();  ///< full width (metres)
  double size_z = std::numeric_limits<double>::infinity();

  /// The largest dot(p, direction) over all points p; infinity where there is none.
  [[nodiscard]] double support(const DVec3& direction) const {
    const auto along = [](double component, double size) {
      return component == 0.0 ? 0.0 : 0.5 * size * std::abs(component);
    };
    return along(direction.x, size_x) + along(direction.z, size_z);
  }

  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const {
    const auto t = intersect_ground(ray);
    if (!t) return std::nullopt;
    const DVec3 p = ray.at(*t);
    if (!(std::abs(p.x) <= 0.5 * size_x && std::abs(p.z) <= 0.5 * size_z)) return std::nullopt;
    return Crossing{.t = *t};
  }

  /// u and v are 0 to 1 across a side that has a size, and metres from the middle on one that has
  /// none.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& /*crossing*/) const {
    const auto [u, du] = across(near.x, size_x);
    const auto [v, dv] = across(near.z, size_z);
    return {{near.x, 0.0, near.z}, {0.0, 1.0, 0.0}, {u, v}, {du, 0.0, 0.0}, {0.0, 0.0, dv}};
  }

 private:
  /// The texture coordinate along one axis, and metres to the unit of it.
  static std::pair<double, double> across(double x, double size) {
    return std::isinf(size) ? std::pair(x, 1.0) : std::pair(x / size + 0.5, size);
  }
};

/// The ring in the plane y = 0 between two circles around the origin, facing +y.
struct Disk {
  double radius = 0.5;        ///< metres
  double inner_radius = 0.0;  ///< of the hole

  [[nodiscard]] double support(const DVec3& direction) const {
    return radius * distance_from_axis(direction);
  }

  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const {
    const auto t = intersect_ground(ray);
    if (!t) return std::nullopt;
    const double ring = distance_from_axis(ray.at(*t));
    if (!(ring >= inner_radius && ring <= radius)) return std::nullopt;
    return Crossing{.t = *t};
  }

  /// The image covers the square around the disk.
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& /*crossing*/) const {
    const double size = 2.0 * radius;
    return {{near.x, 0.0, near.z},
            {0.0, 1.0, 0.0},
            {near.x / size + 0.5, near.z / size + 0.5},
            {size, 0.0, 0.0},
            {0.0, 0.0, size}};
  }
};

}  // namespace lume::geometry
