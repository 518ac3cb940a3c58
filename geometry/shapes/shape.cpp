// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/shape.h"

#include <array>
#include <cmath>

namespace lume::geometry {
namespace {

float float_below(double x) {
  const auto nearest = static_cast<float>(x);
  return std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

}  // namespace

std::optional<Crossing> intersect(const Shape& shape, const ObjectRay& ray) {
  return std::visit([&](const auto& s) { return s.intersect(ray); }, shape);
}

bool meets(const Shape& shape, const ObjectRay& ray) {
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { s.meets(ray); }) {
          return s.meets(ray);
        } else {
          return s.intersect(ray).has_value();
        }
      },
      shape);
}

ShapePoint shape_point(const Shape& shape, const ObjectRay& ray, const Crossing& crossing) {
  return std::visit([&](const auto& s) { return s.point(ray.at(crossing.t), crossing); }, shape);
}

ShapePoint shape_place(const Shape& shape, const ObjectRay& ray, const Crossing& crossing) {
  return std::visit(
      [&](const auto& s) {
        // The compiler leaves out what is not read.
        const ShapePoint point = s.point(ray.at(crossing.t), crossing);
        return ShapePoint{.position = point.position, .normal = point.normal};
      },
      shape);
}

Bounds shape_bounds(const Shape& shape, const Transform& transform) {
  // The largest coordinate i of M p + T is T_i plus the largest dot(p, row i of M).
  const DMat3 rows = glm::transpose(transform.linear());
  const auto support = [&](const DVec3& direction) {
    return std::visit([&](const auto& s) { return s.support(direction); }, shape);
  };
  Bounds bounds;
  for (int i = 0; i < 3; ++i) {
    bounds.lower[i] = float_below(transform.translation()[i] - support(-rows[i]));
    bounds.upper[i] = -float_below(-transform.translation()[i] - support(rows[i]));
  }
  return bounds;
}

const char* shape_name(const Shape& shape) {
  constexpr std::array<const char*, std::variant_size_v<Shape>> k_names = {
      "plane",   "disk",    "box",   "sphere",           "cylinder",      "capsule",
      "quadric", "polygon", "torus", "implicit surface", "Bezier surface"};
  return k_names[shape.index()];
}

}  // namespace lume::geometry
