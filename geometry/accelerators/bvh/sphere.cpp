// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/sphere.h"

#include <algorithm>

namespace lume::geometry::bvh {
namespace {

double square_distance(const Vec3& point, const DVec3& from) {
  const DVec3 way = DVec3(point) - from;
  return dot(way, way);
}

const Vec3& farthest(std::span<const Vec3> points, const Vec3& from) {
  return *std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return square_distance(a, DVec3(from)) < square_distance(b, DVec3(from));
  });
}

/// The smallest sphere around the points that has this center; some 4 roundings are made up for.
BoundingSphere sphere_at(const DVec3& center, std::span<const Vec3> points) {
  double square = 0.0;
  for (const Vec3& point : points) square = std::max(square, square_distance(point, center));
  constexpr double k_rounded_up = 1.0 + 1e-15;
  return {center, std::sqrt(square) * k_rounded_up};
}

/// Two points far apart make a first sphere, and each that is outside pulls it over by as little as
/// it takes.
DVec3 ritter_center(std::span<const Vec3> points) {
  const Vec3& a = farthest(points, points.front());
  const Vec3& b = farthest(points, a);
  DVec3 center = 0.5 * (DVec3(a) + DVec3(b));
  double radius = 0.5 * length(DVec3(b) - DVec3(a));
  for (const Vec3& point : points) {
    const double distance = std::sqrt(square_distance(point, center));
    if (!(distance > radius)) continue;
    radius = 0.5 * (radius + distance);
    center += (1.0 - radius / distance) * (DVec3(point) - center);
  }
  return center;
}

}  // namespace

BoundingSphere BoundingSphere::around(const Bounds& box, std::span<const Vec3> points) {
  const BoundingSphere a = sphere_at(ritter_center(points), points);
  const BoundingSphere b = sphere_at(0.5 * (DVec3(box.lower) + DVec3(box.upper)), points);
  return a.radius < b.radius ? a : b;
}

}  // namespace lume::geometry::bvh
