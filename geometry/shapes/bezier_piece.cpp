// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/bezier_piece.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {
namespace {

/// Widest absolute values of the components.
void widen(DVec3& bounds, const DVec3& v) { bounds = glm::max(bounds, glm::abs(v)); }

}  // namespace

BezierPiece::BezierPiece(const BezierNet<DVec3>& net, std::uint32_t patch_index,
                         const BezierRect& where, double rounding)
    : rect(where), patch(patch_index) {
  const BezierPoint centre = evaluate(net, 0.5, 0.5);
  const DVec3& a = centre.du;
  const DVec3& b = centre.dv;
  middle = centre.position;
  const DVec3 n = cross(a, b);
  const double area = length(n);
  if (!(area > 1e-12 * length(a) * length(b))) return;
  normal = n / area;
  to_x = cross(b, normal) / area;
  to_y = cross(normal, a) / area;

  const auto coordinates = [&](const DVec3& p) {
    return DVec3(dot(to_x, p), dot(to_y, p), dot(normal, p));
  };
  DVec3 lower(std::numeric_limits<double>::infinity());
  DVec3 upper = -lower;
  DVec3 turn_u(0.0);
  DVec3 turn_v(0.0);
  for (std::size_t k = 0; k < 16; ++k) {
    const std::size_t column = k % 4;
    const std::size_t row = k / 4;
    const auto i = static_cast<double>(column);
    const auto j = static_cast<double>(row);
    const DVec3 flat(i / 3.0 - 0.5, j / 3.0 - 0.5, 0.0);
    const DVec3 remainder = coordinates(net[k] - middle) - flat;
    lower = glm::min(lower, remainder);
    upper = glm::max(upper, remainder);
    if (column < 3) widen(turn_u, coordinates(3.0 * (net[k + 1] - net[k]) - a));
    if (row < 3) widen(turn_v, coordinates(3.0 * (net[k + 4] - net[k]) - b));
  }
  turn = turn_u + turn_v;
  const DVec3 offset = 0.5 * (lower + upper);
  middle += offset.x * a + offset.y * b + offset.z * normal;
  rest = 0.5 * (upper - lower) + rounding * DVec3(length(to_x), length(to_y), 1.0) +
         DVec3(k_overlap, k_overlap, 0.0);
}

bool BezierPiece::is_flat() const {
  // A line at 60 degrees from the normal moves sideways by tan(60 degrees) for each metre up.
  constexpr double k_tangent = 1.7;
  const double tilt = k_tangent * turn.z;
  return normal != DVec3(0.0) && turn.x + tilt * length(to_x) <= k_regular &&
         turn.y + tilt * length(to_y) <= k_regular;
}

void meet_piece(const BezierPatch& patch, const BezierPiece& piece, BezierQuery& query) {
  const DVec3& d = query.ray.direction;
  const double approach = dot(piece.normal, d);
  if (approach == 0.0) {
    meet_bent(patch, piece.patch, piece.rect, query);
    return;
  }
  // Where the line meets the plane of the parallelogram, and how far it moves sideways there.
  const DVec3 away = query.start.origin - piece.middle;
  const double s = -dot(piece.normal, away) / approach;
  const DVec3 on_plane = away + s * d;
  const double x = dot(piece.to_x, on_plane);
  const double y = dot(piece.to_y, on_plane);
  const double slope_x = std::abs(dot(piece.to_x, d) / approach);
  const double slope_y = std::abs(dot(piece.to_y, d) / approach);
  if (!(std::abs(x) <= 0.5 + piece.rest.x + slope_x * piece.rest.z) ||
      !(std::abs(y) <= 0.5 + piece.rest.y + slope_y * piece.rest.z)) {
    return;
  }
  if (piece.turn.x + slope_x * piece.turn.z <= k_regular &&
      piece.turn.y + slope_y * piece.turn.z <= k_regular) {
    const BezierRect& rect = piece.rect;
    const double u = rect.u + rect.width * std::clamp(0.5 + x, 0.0, 1.0);
    const double v = rect.v + rect.height * std::clamp(0.5 + y, 0.0, 1.0);
    meet_regular(patch, piece.patch, rect, u, v, query);
  } else {
    meet_bent(patch, piece.patch, piece.rect, query);
  }
}

}  // namespace lume::geometry
