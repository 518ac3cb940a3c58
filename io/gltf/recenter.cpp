// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/recenter.h"

#include <algorithm>
#include <cmath>

namespace lume::io::gltf {
namespace {

using geometry::Bounds;
using geometry::DVec3;
using geometry::Vec3;

/// Something is far when its distance is more than this many times its radius: three bits of a
/// float's 24 would be lost.
constexpr float k_far = 8.0f;

}  // namespace

Vec3 recenter(geometry::Object& object) {
  const Bounds bounds = object.bounds();
  const bool has_shapes = std::any_of(object.geometries.begin(), object.geometries.end(),
                                      [](const auto& each) { return each.shape() != nullptr; });
  if (bounds.is_empty() || has_shapes) {
    return Vec3(0.0f);  // shapes stand around their own origin
  }
  const Vec3 center = bounds.center();
  const float radius = bounds.radius();
  // Only along axes on which it is far: there position / 2 <= center <= 2 * position, for which the
  // difference of two floats is exact (Sterbenz 1974, theorem 4.3.1).
  Vec3 shift(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(center[axis]) > k_far * radius) {
      shift[axis] = center[axis];
    }
  }
  if (shift != Vec3(0.0f)) {
    for (geometry::Geometry& geometry : object.geometries) {
      for (Vec3& position : std::get<geometry::Mesh>(geometry.surface).positions) {
        position -= shift;
      }
    }
  }
  return shift;
}

geometry::DBounds transformed(const Bounds& bounds, const geometry::DMat4& matrix) {
  geometry::DBounds result;
  for (int corner = 0; corner < 8 && !bounds.is_empty(); ++corner) {
    result.add(
        DVec3(matrix * glm::dvec4((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                                  (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                  (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z, 1.0)));
  }
  return result;
}

DVec3 choose_origin(const geometry::DBounds& bounds) {
  if (bounds.is_empty()) {
    return DVec3(0.0);
  }
  const DVec3 center = 0.5 * bounds.lower + 0.5 * bounds.upper;
  const double radius = 0.5 * length(bounds.upper - bounds.lower);
  const double distance = std::max({std::abs(center.x), std::abs(center.y), std::abs(center.z)});
  return distance > static_cast<double>(k_far) * radius ? center : DVec3(0.0);
}

}  // namespace lume::io::gltf
