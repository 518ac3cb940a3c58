// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/bezier_patch.h"

namespace lume::geometry {

BezierPoint evaluate(const BezierPatch& patch, double u, double v) {
  // Derivatives from the differences of control points, so that they vanish exactly on an edge that
  // is collapsed into a point.
  const auto square = [](double t) {
    const double s = 1.0 - t;
    return std::array<double, 3>{s * s, 2.0 * s * t, t * t};
  };
  const auto cube = [](double t) {
    const double s = 1.0 - t;
    return std::array<double, 4>{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
  };
  const auto square_u = square(u);
  const auto square_v = square(v);
  const auto cube_u = cube(u);
  const auto cube_v = cube(v);
  BezierPoint point{DVec3(0.0), DVec3(0.0), DVec3(0.0)};
  std::array<DVec3, 4> row{};
  for (std::size_t j = 0; j < 4; ++j) {
    const DVec3* p = &patch[4 * j];
    row[j] = cube_u[0] * p[0] + cube_u[1] * p[1] + cube_u[2] * p[2] + cube_u[3] * p[3];
    const DVec3 slope =
        square_u[0] * (p[1] - p[0]) + square_u[1] * (p[2] - p[1]) + square_u[2] * (p[3] - p[2]);
    point.position += cube_v[j] * row[j];
    point.du += 3.0 * cube_v[j] * slope;
  }
  for (std::size_t j = 0; j < 3; ++j) point.dv += 3.0 * square_v[j] * (row[j + 1] - row[j]);
  return point;
}

}  // namespace lume::geometry
