// SPDX-License-Identifier: Apache-2.0
// Bicubic Bezier patches: S(u, v) = sum over i, j of B_i(u) B_j(v) P_ij. A ray finds its way
// through a hierarchy of boxes over sub-patches, and the crossing itself by Newton's method.
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/bezier_hierarchy.h"
#include "geometry/shapes/bezier_patch.h"
#include "geometry/shapes/bezier_piece.h"
#include "geometry/shapes/shape_point.h"

#include <optional>
#include <vector>

namespace lume::geometry {

class BezierSurface {
 public:
  /// All coordinates must be finite. Patches that share the control points of an edge join without
  /// a crack.
  explicit BezierSurface(std::vector<BezierPatch> patches);

  /// An upper bound of dot(p, direction) over all points p, tight to about 1% of the surface's
  /// size.
  [[nodiscard]] double support(const DVec3& direction) const;
  /// Crossing::part is the patch, u and v are the patch's.
  [[nodiscard]] std::optional<Crossing> intersect(const ObjectRay& ray) const;
  /// Whether the ray meets the surface at all; cheaper than the closest crossing.
  [[nodiscard]] bool meets(const ObjectRay& ray) const;
  [[nodiscard]] ShapePoint point(const DVec3& near, const Crossing& crossing) const;

  [[nodiscard]] const std::vector<BezierPatch>& patches() const { return patches_; }

 private:
  void add_pieces(const BezierPatch& net, std::uint32_t patch, const BezierRect& rect, int depth,
                  std::vector<DBounds>& boxes);
  [[nodiscard]] std::optional<Crossing> find(const ObjectRay& ray, bool any) const;

  std::vector<BezierPatch> patches_;
  std::vector<BezierPiece> pieces_;
  BezierHierarchy hierarchy_;
  DVec3 middle_{0.0};      ///< of the box around all control points
  double radius_ = 0.0;    ///< of the ball around that box
  double rounding_ = 0.0;  ///< of a point (metres)
};

}  // namespace lume::geometry
