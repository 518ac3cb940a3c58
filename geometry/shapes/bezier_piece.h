// SPDX-License-Identifier: Apache-2.0
// A nearly flat part of a patch, the leaf of a Bezier surface's hierarchy, and how a line meets it.
//
// The piece is the parallelogram middle + x a + y b, |x|, |y| <= 1/2, and a small remainder. In the
// oblique coordinates of (a, b, normal) the remainder and what the derivatives depart from a and b
// are bounded by a few numbers. They tell of almost every line whether it misses the piece, and
// whether Newton's method must find the crossing if there is one.
#pragma once

#include "geometry/shapes/bezier_patch.h"
#include "geometry/shapes/line.h"

#include <cstdint>
#include <limits>

namespace lume::geometry {

struct BezierPiece {
  BezierPiece(const BezierNet<DVec3>& net, std::uint32_t patch_index, const BezierRect& where,
              double rounding);

  DVec3 middle{0.0};
  DVec3 to_x{0.0};  ///< dot(to_x, p - middle) is x
  DVec3 to_y{0.0};
  DVec3 normal{0.0};  ///< unit; 0 if the piece spans no area
  DVec3 rest{0.0};    ///< bounds of the remainder along x, y and normal
  DVec3 turn{0.0};    ///< row sums of the bounds of what the derivatives depart from a and b
  BezierRect rect;
  std::uint32_t patch = 0;

  /// Whether a line may cross the piece far from a right angle and yet take the short way.
  [[nodiscard]] bool is_flat() const;
};

/// A line on its way through a surface, and the closest crossing so far.
struct BezierQuery {
  const ObjectRay& ray;
  LineStart start;
  double rounding = 0.0;  ///< of the surface's points (metres)
  bool any = false;       ///< whether any crossing will do
  Crossing closest{.t = std::numeric_limits<double>::infinity()};
  bool found = false;
};

/// The departure of a map's derivatives up to which Newton's method is sure to converge, see
/// bezier_search.cpp.
inline constexpr double k_regular = 0.3;
/// What a crossing may lie outside of a piece's parameters, so that it is not lost between two.
inline constexpr double k_overlap = 1e-9;

/// Looks for the crossings of the line with one piece.
void meet_piece(const BezierPatch& patch, const BezierPiece& piece, BezierQuery& query);

/// Newton's method in `rect`, from (u, v).
void meet_regular(const BezierPatch& patch, std::uint32_t patch_index, const BezierRect& rect,
                  double u, double v, BezierQuery& query);

/// Looks for the crossings of the line with any part of a patch, however it is bent.
void meet_bent(const BezierPatch& patch, std::uint32_t patch_index, const BezierRect& rect,
               BezierQuery& query);

}  // namespace lume::geometry
