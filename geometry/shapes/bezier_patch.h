// SPDX-License-Identifier: Apache-2.0
// One bicubic Bezier patch: points and derivatives of it, and its parts, which are patches again.
#pragma once

#include "geometry/bounds.h"
#include "geometry/shapes/shape_point.h"

#include <array>
#include <utility>

namespace lume::geometry {

/// Control points; the one of column i (along u) and row j (along v) is [4 * j + i].
template <typename Point>
using BezierNet = std::array<Point, 16>;
using BezierPatch = BezierNet<DVec3>;

/// The box around all control points, and so around the patch.
template <typename Point>
[[nodiscard]] BoundsOf<Point> box_around(const BezierNet<Point>& net) {
  BoundsOf<Point> box;
  for (const Point& p : net) box.add(p);
  return box;
}

/// A rectangle of a patch's parameters.
struct BezierRect {
  double u = 0.0;  ///< of the lower corner
  double v = 0.0;
  double width = 1.0;
  double height = 1.0;

  [[nodiscard]] std::pair<BezierRect, BezierRect> halves(bool along_u) const {
    const double w = along_u ? 0.5 * width : width;
    const double h = along_u ? height : 0.5 * height;
    return {{u, v, w, h}, {along_u ? u + w : u, along_u ? v : v + h, w, h}};
  }
};

/// S(u, v) and its partial derivatives.
struct BezierPoint {
  DVec3 position;
  DVec3 du;
  DVec3 dv;
};

[[nodiscard]] BezierPoint evaluate(const BezierPatch& patch, double u, double v);

/// The two halves of a net, u < 1/2 and u > 1/2 (or v), by de Casteljau's midpoints. What two nets
/// have in common before, a control point or an edge, they have in common after, to the last bit.
template <typename Point>
[[nodiscard]] std::pair<BezierNet<Point>, BezierNet<Point>> halves(const BezierNet<Point>& net,
                                                                   bool along_u) {
  const std::size_t step = along_u ? 1 : 4;
  const std::size_t next_curve = along_u ? 4 : 1;
  std::pair<BezierNet<Point>, BezierNet<Point>> result;
  for (std::size_t curve = 0; curve < 4; ++curve) {
    const std::size_t at = curve * next_curve;
    const Point& a = net[at];
    const Point& d = net[at + 3 * step];
    const Point ab = 0.5 * (a + net[at + step]);
    const Point bc = 0.5 * (net[at + step] + net[at + 2 * step]);
    const Point cd = 0.5 * (net[at + 2 * step] + d);
    const Point abc = 0.5 * (ab + bc);
    const Point bcd = 0.5 * (bc + cd);
    const Point middle = 0.5 * (abc + bcd);
    const Point lower[4] = {a, ab, abc, middle};
    const Point upper[4] = {middle, bcd, cd, d};
    for (std::size_t i = 0; i < 4; ++i) {
      result.first[at + i * step] = lower[i];
      result.second[at + i * step] = upper[i];
    }
  }
  return result;
}

/// The net of the part of a patch from `lower` to `upper` along one of its parameters: its control
/// points are the blossoms b(l, l, l), b(l, l, u), b(l, u, u) and b(u, u, u) of each curve (Ramshaw
/// 1989, "Blossoms are polar forms").
template <typename Point>
[[nodiscard]] BezierNet<Point> part(const BezierNet<Point>& net, bool along_u, double lower,
                                    double upper) {
  const std::size_t step = along_u ? 1 : 4;
  const std::size_t next_curve = along_u ? 4 : 1;
  BezierNet<Point> result;
  for (std::size_t curve = 0; curve < 4; ++curve) {
    const std::size_t at = curve * next_curve;
    const Point p[4] = {net[at], net[at + step], net[at + 2 * step], net[at + 3 * step]};
    const auto blossom = [&](double x, double y, double z) {
      const Point a = (1.0 - x) * p[0] + x * p[1];
      const Point b = (1.0 - x) * p[1] + x * p[2];
      const Point c = (1.0 - x) * p[2] + x * p[3];
      return (1.0 - z) * ((1.0 - y) * a + y * b) + z * ((1.0 - y) * b + y * c);
    };
    result[at] = blossom(lower, lower, lower);
    result[at + step] = blossom(lower, lower, upper);
    result[at + 2 * step] = blossom(lower, upper, upper);
    result[at + 3 * step] = blossom(upper, upper, upper);
  }
  return result;
}

template <typename Point>
[[nodiscard]] BezierNet<Point> part(const BezierNet<Point>& net, const BezierRect& rect) {
  return part(part(net, true, rect.u, rect.u + rect.width), false, rect.v, rect.v + rect.height);
}

}  // namespace lume::geometry
