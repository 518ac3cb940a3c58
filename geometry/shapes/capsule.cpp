// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/capsule.h"

#include "geometry/shapes/line.h"

#include <algorithm>

namespace lume::geometry {
namespace {

/// The stretch of a line inside the sphere around (0, y, 0).
Span inside_ball(const DVec3& origin, const DVec3& direction, double y, double radius,
                 std::uint32_t part) {
  const DVec3 o = origin - DVec3(0.0, y, 0.0);
  const double a = dot(direction, direction);
  const double nearest = -dot(o, direction) / a;
  const DVec3 p = o + nearest * direction;
  // As for Sphere: the distance of the line from the centre, without cancellation.
  const double half = std::sqrt((radius * radius - dot(p, p)) / a);
  return {nearest - half, nearest + half, part, part};
}

}  // namespace

Capsule::Capsule(double height, double radius_bottom, double radius_top)
    : bottom_{-0.5 * height, radius_bottom}, top_{0.5 * height, radius_top} {
  // The touching cone's side makes an angle with the axis whose sine is the slope of the radii.
  const double sine = (radius_bottom - radius_top) / height;
  has_side_ = std::abs(sine) < 1.0;
  if (!has_side_) return;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const double y_bottom = bottom_.y + radius_bottom * sine;
  const double y_top = top_.y + radius_top * sine;
  side_ = {y_top - y_bottom, radius_bottom * cosine, radius_top * cosine};
  side_y_ = 0.5 * (y_bottom + y_top);
}

double Capsule::support(const DVec3& direction) const {
  const double size = length(direction);
  return std::max(bottom_.y * direction.y + bottom_.radius * size,
                  top_.y * direction.y + top_.radius * size);
}

std::optional<Crossing> Capsule::intersect(const ObjectRay& ray) const {
  const auto [shift, o] = start_near(ray, DVec3(0.0), top_.y + bottom_.radius + top_.radius);
  const DVec3& d = ray.direction;
  Span span = hull(inside_ball(o, d, bottom_.y, bottom_.radius, bottom),
                   inside_ball(o, d, top_.y, top_.radius, top));
  if (has_side_) {
    Span beside = side_.inside(o - DVec3(0.0, side_y_, 0.0), d);
    beside.enter_part = beside.leave_part = side;  // its ends are inside the spheres
    span = hull(span, beside);
  }
  return first_end(shifted(span, shift), ray);
}

ShapePoint Capsule::point(const DVec3& near, const Crossing& crossing) const {
  const double y_lower = std::min(bottom_.y - bottom_.radius, top_.y - top_.radius);
  const double y_upper = std::max(bottom_.y + bottom_.radius, top_.y + top_.radius);
  if (crossing.part == side) {
    const DVec3 middle(0.0, side_y_, 0.0);
    const ShapePoint beside = side_.point(near - middle, {.part = Cylinder::side});
    return cylindrical_point(beside.position + middle, beside.normal, y_lower, y_upper);
  }
  const Ball& ball = crossing.part == top ? top_ : bottom_;
  const DVec3 center(0.0, ball.y, 0.0);
  const DVec3 normal = normalize(near - center);
  return cylindrical_point(center + ball.radius * normal, normal, y_lower, y_upper);
}

}  // namespace lume::geometry
