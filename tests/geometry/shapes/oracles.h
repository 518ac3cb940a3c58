// SPDX-License-Identifier: Apache-2.0
// Every crossing of a ray with a shape by the textbook's formula in 113-bit arithmetic: planes and
// quadratics, whose solutions are kept if they lie on the part that there is. Nothing is shared
// with the shapes under test but their parameters.
#pragma once

#include "geometry/shapes/quadric.h"
#include "tests/geometry/shapes/high_precision.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace lume::test {

struct OracleCrossing {
  Real t;
  geometry::DVec3 normal;  ///< towards the front, of any length
};
using OracleCrossings = std::vector<OracleCrossing>;

/// All crossings in no order, of the shape grown by `slack` to all sides (shrunk if negative).
using Oracle = std::function<OracleCrossings(const RealRay& ray, double slack)>;

/// The solutions of a t^2 + 2 b t + c = 0.
inline std::vector<Real> naive_roots(Real a, Real b, Real c) {
  if (a == 0) return b == 0 ? std::vector<Real>{} : std::vector<Real>{-c / (2 * b)};
  const Real discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  const Real root = square_root(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

/// Calls on_part(p) for the crossing with x[axis] = value, and keeps it if that says so.
template <class OnPart>
void add_plane(OracleCrossings& found, const RealRay& ray, int axis, Real value, double facing,
               const OnPart& on_part) {
  if (ray.direction[axis] == 0) return;
  const Real t = (value - ray.origin[axis]) / ray.direction[axis];
  geometry::DVec3 normal(0.0);
  normal[axis] = facing;
  if (on_part(ray.at(t))) found.push_back({t, normal});
}

/// The crossings with the sphere around (0, y, 0) where on_part(p).
template <class OnPart>
void add_ball(OracleCrossings& found, const RealRay& ray, Real y, Real radius,
              const OnPart& on_part) {
  const RealVector center(0, y, 0);
  const RealVector o = ray.origin - center;
  for (const Real t : naive_roots(dot(ray.direction, ray.direction), dot(o, ray.direction),
                                  dot(o, o) - radius * radius)) {
    const RealVector p = ray.at(t);
    if (on_part(p)) found.push_back({t, (p - center).rounded()});
  }
}

/// The crossings with x^2 + z^2 = (radius + slope y)^2 where on_part(p).
template <class OnPart>
void add_cone(OracleCrossings& found, const RealRay& ray, Real radius, Real slope,
              const OnPart& on_part) {
  const RealVector& o = ray.origin;
  const RealVector& d = ray.direction;
  const Real r = radius + slope * o.y;
  const Real dr = slope * d.y;
  for (const Real t : naive_roots(d.x * d.x + d.z * d.z - dr * dr, o.x * d.x + o.z * d.z - r * dr,
                                  o.x * o.x + o.z * o.z - r * r)) {
    const RealVector p = ray.at(t);
    const Real at_p = radius + slope * p.y;
    if (at_p >= 0 && on_part(p))
      found.push_back({t, RealVector(p.x, -slope * at_p, p.z).rounded()});
  }
}

inline Oracle sphere_oracle(double radius) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    add_ball(found, ray, 0, Real(radius) + slack, [](const RealVector&) { return true; });
    return found;
  };
}

inline Oracle rectangle_oracle(double size_x, double size_z) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    add_plane(found, ray, 1, 0, 1.0, [&](const RealVector& p) {
      return magnitude(p.x) <= size_x / 2 + slack && magnitude(p.z) <= size_z / 2 + slack;
    });
    return found;
  };
}

inline Oracle disk_oracle(double radius, double inner_radius) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    add_plane(found, ray, 1, 0, 1.0, [&](const RealVector& p) {
      const Real ring = square_root(p.x * p.x + p.z * p.z);
      return ring <= Real(radius) + slack && ring >= Real(inner_radius) - slack;
    });
    return found;
  };
}

inline Oracle box_oracle(const geometry::DVec3& half_size) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    const auto on_part = [&](int axis) {
      return [&, axis](const RealVector& p) {
        for (int i = 0; i < 3; ++i) {
          if (i != axis && magnitude(p[i]) > Real(half_size[i]) + slack) return false;
        }
        return true;
      };
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Real h = Real(half_size[axis]) + slack;
      add_plane(found, ray, axis, -h, -1.0, on_part(axis));
      add_plane(found, ray, axis, h, 1.0, on_part(axis));
    }
    return found;
  };
}

inline Oracle cylinder_oracle(double height, double radius_bottom, double radius_top) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    const Real half = Real(height) / 2;
    const Real slope = (Real(radius_top) - radius_bottom) / height;
    const Real middle = (Real(radius_top) + radius_bottom) / 2 + slack;
    add_cone(found, ray, middle, slope,
             [&](const RealVector& p) { return magnitude(p.y) <= half + slack; });
    for (const int side : {-1, 1}) {
      const Real radius = Real(side < 0 ? radius_bottom : radius_top) + slack;
      add_plane(found, ray, 1, side * (half + slack), side, [&](const RealVector& p) {
        return radius >= 0 && p.x * p.x + p.z * p.z <= radius * radius;
      });
    }
    return found;
  };
}

/// Of each sphere what is on its side of the circle where the cone touches it; of the cone what is
/// between the circles.
inline Oracle capsule_oracle(double height, double radius_bottom, double radius_top) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    const Real rb = Real(radius_bottom) + slack;
    const Real rt = Real(radius_top) + slack;
    const Real sine = (rb - rt) / height;
    if (magnitude(sine) >= 1) {
      const bool is_bottom = rb > rt;
      add_ball(found, ray, Real(height) / (is_bottom ? -2 : 2), is_bottom ? rb : rt,
               [](const RealVector&) { return true; });
      return found;
    }
    const Real cosine = square_root(1 - sine * sine);
    const Real y_bottom = -Real(height) / 2 + rb * sine;
    const Real y_top = Real(height) / 2 + rt * sine;
    const Real slope = (rt - rb) * cosine / (y_top - y_bottom);
    add_ball(found, ray, -Real(height) / 2, rb,
             [&](const RealVector& p) { return p.y <= y_bottom; });
    add_ball(found, ray, Real(height) / 2, rt, [&](const RealVector& p) { return p.y >= y_top; });
    add_cone(found, ray, rb * cosine - slope * y_bottom, slope,
             [&](const RealVector& p) { return p.y >= y_bottom && p.y <= y_top; });
    return found;
  };
}

/// Slack moves the box, and the constant by what the gradient makes of it; `gradient` is a typical
/// length of it.
inline Oracle quadric_oracle(const geometry::DMat4& q, const geometry::DVec3& lower,
                             const geometry::DVec3& upper, bool caps, double gradient) {
  return [=](const RealRay& ray, double slack) {
    OracleCrossings found;
    /// p^T Q q for points (weight 1) and directions (weight 0).
    const auto product = [&](const RealVector& p, Real p_weight, const RealVector& r,
                             Real r_weight) {
      const std::array<Real, 4> left = {p.x, p.y, p.z, p_weight};
      const std::array<Real, 4> right = {r.x, r.y, r.z, r_weight};
      Real sum = 0;
      for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
          if (q[i][k] == 0.0) continue;  // 113 bits are slow
          sum += q[i][k] * left[static_cast<std::size_t>(i)] * right[static_cast<std::size_t>(k)];
        }
      }
      return sum;
    };
    const auto value = [&](const RealVector& p) { return product(p, 1, p, 1) - slack * gradient; };
    const auto is_in_box = [&](const RealVector& p, int but_axis) {
      for (int i = 0; i < 3; ++i) {
        if (i != but_axis && (p[i] < lower[i] - slack || p[i] > upper[i] + slack)) return false;
      }
      return true;
    };
    const RealVector& d = ray.direction;
    for (const Real t :
         naive_roots(product(d, 0, d, 0), product(ray.origin, 1, d, 0), value(ray.origin))) {
      const RealVector p = ray.at(t);
      if (!is_in_box(p, -1)) continue;
      const std::array<Real, 4> h = {p.x, p.y, p.z, 1};
      geometry::DVec3 normal(0.0);
      for (int i = 0; i < 3; ++i) {
        Real sum = 0;
        for (int k = 0; k < 4; ++k) sum += 2 * q[k][i] * h[static_cast<std::size_t>(k)];
        normal[i] = static_cast<double>(sum);
      }
      found.push_back({t, normal});
    }
    for (int axis = 0; caps && axis < 3; ++axis) {
      const auto on_part = [&](const RealVector& p) { return is_in_box(p, axis) && value(p) <= 0; };
      if (std::isfinite(lower[axis])) {
        add_plane(found, ray, axis, Real(lower[axis]) - slack, -1.0, on_part);
      }
      if (std::isfinite(upper[axis])) {
        add_plane(found, ray, axis, Real(upper[axis]) + slack, 1.0, on_part);
      }
    }
    return found;
  };
}

/// By the angles under which the loops' edges are seen: a loop turns a whole number of times around
/// a point, and odd numbers of turns in all are inside. `normal` is that of the loops' plane.
inline Oracle polygon_oracle(const std::vector<std::vector<geometry::DVec3>>& loops,
                             const geometry::DVec3& normal) {
  return [=](const RealRay& ray, double slack) {
    using geometry::DVec3;
    const RealVector n(normal);
    const Real approach = dot(n, ray.direction);
    if (approach == 0) return OracleCrossings{};
    const Real t = dot(n, RealVector(loops[0][0]) - ray.origin) / approach;
    const RealVector p = ray.at(t);
    double turns = 0.0;
    for (const std::vector<DVec3>& loop : loops) {
      double angle = 0.0;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const DVec3 a = (RealVector(loop[i]) - p).rounded();
        const DVec3 b = (RealVector(loop[(i + 1) % loop.size()]) - p).rounded();
        angle += std::atan2(glm::dot(glm::cross(a, b), normal), glm::dot(a, b));
        const DVec3 edge = b - a;
        const double along = std::clamp(-glm::dot(a, edge) / glm::dot(edge, edge), 0.0, 1.0);
        if (glm::length(a + along * edge) < std::abs(slack)) {
          return slack > 0.0 ? OracleCrossings{{t, normal}} : OracleCrossings{};
        }
      }
      turns += std::round(angle / (2.0 * std::numbers::pi));
    }
    const bool is_inside = std::abs(std::remainder(turns, 2.0)) > 0.5;
    return is_inside ? OracleCrossings{{t, normal}} : OracleCrossings{};
  };
}

}  // namespace lume::test
