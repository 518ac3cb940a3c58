// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/projector.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry::zbuffer {
namespace {

/// At least the factor by which a matrix makes vectors longer (the Frobenius norm).
double norm(const DMat3& m) {
  return std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
}

/// A triangle whose volume or area is that much smaller than the product of its sides is seen from
/// the side, or as good as: which side of its edges a ray is on tells nothing.
constexpr double k_steepest = 1e6;

void scale(Affine& affine, double factor) {
  affine.x *= factor;
  affine.y *= factor;
  affine.constant *= factor;
}

}  // namespace

Projector::Projector(const View& view, const Transform& transform)
    : view_(view),
      eye_(transform.point_to_object(view.eye())),
      to_image_(view.to_image() * transform.linear()),
      scale_(norm(view.to_image()) * norm(transform.linear())) {
  // Some hundreds of roundings, each made larger on the way to the object's space and back.
  constexpr double k_rounding = 1e-13;
  rounding_ = k_rounding * norm(transform.linear()) * norm(transform.inverse_linear());
  const Rect all = view.rect({glm::ivec2(0), view.size()});
  reach_ = std::sqrt(1.0 + dot(all.upper, all.upper));
  // Rays of an orthographic camera each begin at a place of their own.
  if (!view.is_perspective()) {
    far_ = norm(view.to_image()) * (length(view.eye()) + length(transform.translation())) + reach_;
  }
}

Projector::Sight Projector::see(const Vec3& point) const {
  const DVec3 way = DVec3(point) - eye_;
  const double size = scale_ * length(way);
  return {to_image_ * way, size, rounding_ * (size + far_)};
}

Projector::Side Projector::side(const Vec3& from, const Vec3& to) const {
  const DVec3 way = DVec3(to) - DVec3(from);
  return {to_image_ * way, scale_ * length(way)};
}

/// The bounds around points, if they can be told; else they are the whole picture. None if all are
/// behind the camera.
std::optional<Footprint> Projector::frame(std::span<const Sight> points) const {
  Footprint result;
  const Rect all = view_.rect({glm::ivec2(0), view_.size()});
  const double most_error = 0.005 * (all.upper.y - all.lower.y) / view_.size().y;
  double least_depth = std::numeric_limits<double>::infinity();
  double most_depth = -least_depth;
  bool is_clear = true;
  for (const Sight& point : points) {
    least_depth = std::min(least_depth, point.place.z - point.error);
    most_depth = std::max(most_depth, point.place.z + point.error);
    const double depth = view_.is_perspective() ? point.place.z - point.error : 1.0;
    const glm::dvec2 place = glm::dvec2(point.place) / depth;
    const double error = point.error / depth * (1.0 + std::abs(place.x) + std::abs(place.y));
    is_clear = is_clear && depth > 0.0 && error < most_error;
    result.bounds.add(place);
  }
  if (most_depth < -view_.start_depth()) return std::nullopt;
  if (!is_clear) {
    result.bounds = all;
  } else {
    result.nearest_corner = view_.is_perspective() ? 1.0 / least_depth : -least_depth;
  }
  return result;
}

std::optional<Footprint> Projector::box(const Bounds& bounds) const {
  std::array<Sight, 8> points;
  for (unsigned corner = 0; corner < 8; ++corner) {
    points[corner] = see({(corner & 1U) != 0 ? bounds.upper.x : bounds.lower.x,
                          (corner & 2U) != 0 ? bounds.upper.y : bounds.lower.y,
                          (corner & 4U) != 0 ? bounds.upper.z : bounds.lower.z});
  }
  return frame(points);
}

std::optional<Footprint> Projector::triangle(const std::array<Vec3, 3>& corners,
                                             bool has_holes) const {
  const Corners points{see(corners[0]), see(corners[1]), see(corners[2])};
  std::optional<Footprint> result = frame(points);
  if (!result) return result;
  const Sides sides{side(corners[1], corners[2]), side(corners[2], corners[0]),
                    side(corners[0], corners[1])};
  result->is_solid = !has_holes;
  if (view_.is_perspective()) {
    add_cone(points, sides, *result);
  } else {
    add_prism(points, sides, *result);
  }
  return result;
}

/// For r = (x, y, 1) and corners a, b, c: r = sum of a_i corner_i, with a_0 = r . (b x c) / volume
/// and so on. The ray is inside where all a_i are above 0, and its depth is 1 / (their sum).
void Projector::add_cone(const Corners& corners, const Sides& sides, Footprint& result) const {
  const double size = std::max({corners[0].size, corners[1].size, corners[2].size});
  const DVec3 normal = cross(sides[2].way, -sides[1].way);
  const double volume = dot(corners[0].place, normal);
  const double size_of_normal = sides[1].size * sides[2].size;
  const double steepness = size * size_of_normal / std::abs(volume);
  if (!(steepness < k_steepest)) {
    result.is_solid = false;
    return;
  }
  const double sign = volume < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const DVec3 plane = sign * cross(corners[(i + 1) % 3].place, sides[i].way);
    result.edges[i] = {{plane.x, plane.y, plane.z}, rounding_ * size * sides[i].size * reach_};
  }
  result.nearness = {normal.x, normal.y, normal.z};
  scale(result.nearness, 1.0 / volume);
  result.nearness_slack =
      rounding_ * size_of_normal * reach_ / std::abs(volume) * (1.0 + steepness);
}

/// The same where all rays run along the axis of depth: edges are lines in the picture, and the
/// depth is that of the triangle's plane.
void Projector::add_prism(const Corners& corners, const Sides& sides, Footprint& result) const {
  const double error = std::max({corners[0].error, corners[1].error, corners[2].error});
  const double size = std::max({corners[0].size, corners[1].size, corners[2].size}) + reach_;
  const DVec3 normal = cross(sides[2].way, -sides[1].way);
  const double steepness = sides[1].size * sides[2].size / std::abs(normal.z);
  const auto is_behind = [this](const Sight& corner) {
    return corner.place.z - corner.error <= view_.start_depth();
  };
  const bool is_in_front = std::none_of(corners.begin(), corners.end(), is_behind);
  result.is_solid = result.is_solid && is_in_front && steepness < k_steepest;
  if (!(steepness < k_steepest)) return;
  const double sign = normal.z < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const DVec3 way = sign * sides[i].way;
    const DVec3& from = corners[(i + 1) % 3].place;
    result.edges[i] = {{-way.y, way.x, way.y * from.x - way.x * from.y},
                       2.0 * sides[i].size * (error + rounding_ * size)};
  }
  const DVec3& at = corners[0].place;
  result.nearness = {normal.x, normal.y, -dot(normal, at)};
  scale(result.nearness, 1.0 / normal.z);
  result.nearness_slack = (error + rounding_ * size * steepness) * (1.0 + steepness);
}

}  // namespace lume::geometry::zbuffer
