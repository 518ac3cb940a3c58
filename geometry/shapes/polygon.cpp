// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/polygon.h"

#include "geometry/shapes/plane.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {

DVec3 Polygon::normal_of(const std::vector<DVec3>& loop) {
  // Each component is twice the area of the loop's shadow on a coordinate plane (Sutherland,
  // Sproull and Schumacker 1974 call it Newell's method). Relative to a corner, so that a polygon
  // far from the origin loses nothing.
  DVec3 sum(0.0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  }
  const double size = length(sum);
  return size > 0.0 ? sum / size : DVec3(0.0);
}

Polygon::Polygon(std::vector<std::vector<DVec3>> loops) : normal_(normal_of(loops.at(0))) {
  distance_ = dot(normal_, loops[0][0]);
  const DVec3 size = glm::abs(normal_);
  const int dropped = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  axis_u_ = (dropped + 1) % 3;
  axis_v_ = (dropped + 2) % 3;

  // An image hangs upright on the polygon; on one that lies flat its right is +x.
  const DVec3 up(0.0, 1.0, 0.0);
  const DVec3 to_right = size.y > 0.999 ? DVec3(1.0, 0.0, 0.0) : cross(up, normal_);
  right_ = normalize(to_right - dot(to_right, normal_) * normal_);
  down_ = cross(right_, normal_);
  DVec2 lower(std::numeric_limits<double>::infinity());
  DVec2 upper(-lower);
  for (std::vector<DVec3>& loop : loops) {
    for (DVec3& corner : loop) {
      corner += (distance_ - dot(normal_, corner)) * normal_;
      const DVec2 in_image(dot(right_, corner), dot(down_, corner));
      lower = glm::min(lower, in_image);
      upper = glm::max(upper, in_image);
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      DVec2 from(loop[i][axis_u_], loop[i][axis_v_]);
      const DVec3& next = loop[(i + 1) % loop.size()];
      DVec2 to(next[axis_u_], next[axis_v_]);
      if (from.y > to.y) std::swap(from, to);  // so that both neighbours of an edge agree on it
      edges_.push_back({from, to});
    }
    corners_.insert(corners_.end(), loop.begin(), loop.end());
  }
  image_origin_ = lower;
  image_size_ = upper - lower;
}

double Polygon::support(const DVec3& direction) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const DVec3& corner : corners_) largest = std::max(largest, dot(corner, direction));
  return largest;
}

bool Polygon::is_inside(const DVec2& p) const {
  bool inside = false;
  for (const Edge& edge : edges_) {
    // Relative to the point a line to the right is the positive u-axis. Three edges in four need no
    // division: those above or below it, those to the left, and those wholly to the right.
    const DVec2 from = edge.from - p;
    const DVec2 to = edge.to - p;
    if ((from.y > 0.0) == (to.y > 0.0)) continue;
    if (from.x < 0.0 && to.x < 0.0) continue;
    const bool is_right = (from.x >= 0.0 && to.x >= 0.0) || from.x * to.y >= to.x * from.y;
    if (is_right) inside = !inside;
  }
  return inside;
}

std::optional<Crossing> Polygon::intersect(const ObjectRay& ray) const {
  const auto t = intersect_plane(ray, normal_, distance_);
  if (!t) return std::nullopt;
  const DVec3 p = ray.at(*t);
  if (!is_inside({p[axis_u_], p[axis_v_]})) return std::nullopt;
  return Crossing{.t = *t};
}

ShapePoint Polygon::point(const DVec3& near, const Crossing& /*crossing*/) const {
  const DVec2 in_image = DVec2(dot(right_, near), dot(down_, near)) - image_origin_;
  return {near + (distance_ - dot(normal_, near)) * normal_, normal_, in_image / image_size_,
          image_size_.x * right_, image_size_.y * down_};
}

}  // namespace lume::geometry
