// SPDX-License-Identifier: Apache-2.0
#include "renderer/emitter_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lume::renderer {
namespace {

using geometry::Disk;
using geometry::DVec2;
using geometry::DVec3;
using geometry::k_turn;
using geometry::Plane;
using geometry::Shape;
using geometry::ShapePoint;
using geometry::Sphere;
using geometry::Transform;
using geometry::Vec2;

/// The unit vector at `height` above the equator of +z.
DVec3 on_unit_sphere(double height, double longitude) {
  const double ring = std::sqrt(std::max(0.0, (1.0 - height) * (1.0 + height)));
  return {ring * std::cos(longitude), ring * std::sin(longitude), height};
}

/// Slices of equal height have equal area (Archimedes).
ShapePoint uniform(const Sphere& sphere, DVec2 random) {
  return sphere.point(on_unit_sphere(1.0 - 2.0 * random.x, k_turn * random.y), {});
}

ShapePoint uniform(const Plane& plane, DVec2 random) {
  return plane.point({plane.size_x * (random.x - 0.5), 0.0, plane.size_z * (random.y - 0.5)}, {});
}

/// Rings of equal difference of radius^2 have equal area.
ShapePoint uniform(const Disk& disk, DVec2 random) {
  const double inner2 = disk.inner_radius * disk.inner_radius;
  const double outer2 = disk.radius * disk.radius;
  const double radius = std::sqrt(inner2 + (outer2 - inner2) * random.x);
  const double angle = k_turn * random.y;
  return disk.point({radius * std::sin(angle), 0.0, radius * std::cos(angle)}, {});
}

double object_area(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    return 2.0 * k_turn * sphere->radius * sphere->radius;
  }
  if (const auto* plane = std::get_if<Plane>(&shape)) return plane->size_x * plane->size_z;
  const auto& disk = std::get<Disk>(shape);
  return 0.5 * k_turn * (disk.radius - disk.inner_radius) * (disk.radius + disk.inner_radius);
}

/// What a m^2 of the object's surface with unit normal n becomes in the scene: |det M| |M^-T n|,
/// the length of the cofactor matrix times n (Nanson's formula of continuum mechanics).
double area_scale(const Transform& transform, const DVec3& normal) {
  return std::abs(glm::determinant(transform.linear())) *
         length(transform.normal_to_world(normalize(normal)));
}

/// The cone around the direction to the centre that a sphere fills, as seen from outside.
struct Cone {
  double sine2;   ///< of its half angle: r^2 / d^2
  double cosine;  ///< from (d - r)(d + r), where 1 - sine2 would lose a point near the surface

  Cone(const Sphere& sphere, double distance)
      : sine2(sphere.radius / distance * (sphere.radius / distance)),
        cosine(std::sqrt((distance - sphere.radius) * (distance + sphere.radius)) / distance) {}

  /// 1 - cosine, which fills 2 pi times as many steradians, without cancelling for small cones.
  [[nodiscard]] double height() const { return sine2 / (1.0 + cosine); }
};

/// The direction is at the angle a from the cone's axis with 1 - cos(a) uniform. The sphere's
/// normal where it first meets the sphere is at b from the direction, sin(b) = sin(a) / sin(half
/// angle), by the law of sines, so at b - a from the axis, which points back from the centre.
ShapePoint point_from_outside(const Sphere& sphere, const DVec3& from, double distance,
                              DVec2 random) {
  const Cone cone(sphere, distance);
  const double height = random.x * cone.height();
  const double ratio2 = random.x * (2.0 - height) / (1.0 + cone.cosine);  // sin^2(b)
  const double sine_a = std::sqrt(ratio2 * cone.sine2);
  const double cosine_a = 1.0 - height;
  const double sine_b = std::sqrt(ratio2);
  const double cosine_b = std::sqrt(std::max(0.0, 1.0 - ratio2));
  const double sine = sine_b * cosine_a - cosine_b * sine_a;
  const double cosine = cosine_b * cosine_a + sine_b * sine_a;

  const DVec3 axis = from / distance;
  const DVec3 helper = std::abs(axis.x) < 0.5 ? DVec3(1.0, 0.0, 0.0) : DVec3(0.0, 1.0, 0.0);
  const DVec3 tangent = normalize(cross(helper, axis));
  const DVec3 bitangent = cross(axis, tangent);
  const double angle = k_turn * random.y;
  return sphere.point(
      cosine * axis + sine * (std::cos(angle) * tangent + std::sin(angle) * bitangent), {});
}

ShapePoint point_from_inside(const Sphere& sphere, const DVec3& from, DVec2 random) {
  const DVec3 direction = on_unit_sphere(1.0 - 2.0 * random.x, k_turn * random.y);
  const double b = dot(from, direction);
  const double c = (length(from) - sphere.radius) * (length(from) + sphere.radius);
  const double t = -b + std::sqrt(std::max(0.0, b * b - c));
  return sphere.point(from + t * direction, {});
}

bool is_outside(const Sphere& sphere, double distance) { return distance > sphere.radius; }

}  // namespace

bool is_area_light(const Shape& shape) {
  if (const auto* plane = std::get_if<Plane>(&shape)) {
    return std::isfinite(plane->size_x) && std::isfinite(plane->size_z);
  }
  return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Disk>(shape);
}

ShapePoint uniform_point(const Shape& shape, Vec2 random) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return uniform(*sphere, DVec2(random));
  if (const auto* plane = std::get_if<Plane>(&shape)) return uniform(*plane, DVec2(random));
  return uniform(std::get<Disk>(shape), DVec2(random));
}

double world_area(const Shape& shape, const Transform& transform) {
  if (!std::holds_alternative<Sphere>(shape)) {
    return object_area(shape) * area_scale(transform, {0.0, 1.0, 0.0});
  }
  // There is no closed form for an ellipsoid. Even a needle is within a few percent of this mean.
  constexpr int k_grid = 16;
  double sum = 0.0;
  for (int i = 0; i < k_grid; ++i) {
    for (int j = 0; j < k_grid; ++j) {
      const Vec2 cell(static_cast<float>(i), static_cast<float>(j));
      const Vec2 middle = (cell + 0.5f) / static_cast<float>(k_grid);
      sum += area_scale(transform, uniform_point(shape, middle).normal);
    }
  }
  return object_area(shape) * sum / (k_grid * k_grid);
}

ShapePoint point_seen_from(const Sphere& sphere, const DVec3& from, Vec2 random) {
  const double distance = length(from);
  return is_outside(sphere, distance) ? point_from_outside(sphere, from, distance, DVec2(random))
                                      : point_from_inside(sphere, from, DVec2(random));
}

double direction_pdf(const Sphere& sphere, const Transform& transform, const DVec3& position,
                     const DVec3& normal, const DVec3& from) {
  const double distance = length(transform.point_to_object(from));
  const bool outside = is_outside(sphere, distance);
  const DVec3 offset = position - from;
  if (outside && !(dot(normal, offset) < 0.0)) return 0.0;
  const double object_steradians = k_turn * (outside ? Cone(sphere, distance).height() : 2.0);
  // A thin cone of dw' steradians of object directions w' and of length 1 has the volume dw' / 3.
  // M makes of it a cone of length |M w'| and of the volume |det M| dw' / 3 = |M w'|^3 dw / 3.
  // Hence dw'/dw = |M w'|^3 / |det M|; and M takes the offset in object space to the one in the
  // scene.
  const double stretch = length(offset) / length(transform.vector_to_object(offset));
  const double steradian_ratio =
      stretch * stretch * stretch / std::abs(glm::determinant(transform.linear()));
  return steradian_ratio / object_steradians;
}

}  // namespace lume::renderer
