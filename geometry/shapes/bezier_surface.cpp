// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/bezier_surface.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {
namespace {

constexpr int k_max_cuts = 8;  ///< of a patch, so it has at most 256 pieces

/// Whether a patch is more than a point or a piece of a straight line.
bool spans_area(const BezierPatch& net, double rounding) {
  DVec3 farthest(0.0);
  for (const DVec3& p : net) {
    const DVec3 away = p - net[0];
    if (dot(away, away) > dot(farthest, farthest)) farthest = away;
  }
  const double length_of_line = length(farthest);
  return std::any_of(net.begin(), net.end(), [&](const DVec3& p) {
    return length(cross(farthest, p - net[0])) > rounding * length_of_line;
  });
}

double largest(const DVec3& v) { return std::max({v.x, v.y, v.z}); }

/// Whether the curves along u bend more than those along v.
bool bends_along_u(const BezierPatch& net) {
  double along_u = 0.0;
  double along_v = 0.0;
  for (std::size_t k = 0; k < 16; ++k) {
    const auto bend = [&](std::size_t step) {
      const DVec3 second = net[k + 2 * step] - 2.0 * net[k + step] + net[k];
      return dot(second, second);
    };
    if (k % 4 < 2) along_u = std::max(along_u, bend(1));
    if (k / 4 < 2) along_v = std::max(along_v, bend(4));
  }
  return along_u > along_v;
}

/// A normal, of any length. Where an edge is collapsed into a point, or two edges leave a corner in
/// one direction, there is none: then its limit, from a point a little towards the middle.
DVec3 normal_at(const BezierPatch& patch, double u, double v) {
  constexpr double k_flat = 1e-7;  // sine of the angle, or ratio of the derivatives
  DVec3 normal(0.0, 1.0, 0.0);
  for (const double step : {0.0, 1e-6, 1e-4, 1e-2}) {
    const BezierPoint at = evaluate(patch, u + step * (0.5 - u), v + step * (0.5 - v));
    const DVec3 n = cross(at.dv, at.du);
    const double longest = std::max(dot(at.du, at.du), dot(at.dv, at.dv));
    if (dot(n, n) > 0.0) normal = n;
    if (length(n) > k_flat * longest) break;
  }
  return normal;
}

/// The slabs of a ray's line through both boxes of a node, as the stretches of t inside.
struct Slabs {
  double enter[2];
  double leave[2];
};

/// A direction with its components inverted; large instead of infinite, so that no product with
/// the distance 0 is undefined.
DVec3 inverse_of(const DVec3& direction) {
  constexpr double k_large = 1e300;
  DVec3 inverse = 1.0 / direction;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(inverse[axis]) < k_large)) inverse[axis] = k_large;
  }
  return inverse;
}

Slabs slabs(const BezierHierarchy::Node& node, const DVec3& origin, const DVec3& inverse,
            double t_min, double t_max) {
  Slabs result{{t_min, t_min}, {t_max, t_max}};
  for (int axis = 0; axis < 3; ++axis) {
    const auto& near = inverse[axis] < 0.0 ? node.upper[axis] : node.lower[axis];
    const auto& far = inverse[axis] < 0.0 ? node.lower[axis] : node.upper[axis];
    for (int side = 0; side < 2; ++side) {
      const double enter = (near[side] - origin[axis]) * inverse[axis];
      const double leave = (far[side] - origin[axis]) * inverse[axis];
      result.enter[side] = std::max(result.enter[side], enter);
      result.leave[side] = std::min(result.leave[side], leave);
    }
  }
  return result;
}

}  // namespace

BezierSurface::BezierSurface(std::vector<BezierPatch> patches) : patches_(std::move(patches)) {
  if (patches_.empty()) return;
  DBounds all;
  for (const BezierPatch& patch : patches_) all.add(box_around(patch));
  middle_ = all.center();
  const double size = largest(all.size());
  const double far = largest(glm::max(glm::abs(all.lower), glm::abs(all.upper)));
  rounding_ = 4.0 * std::numeric_limits<double>::epsilon() * std::max(size, far);
  radius_ = all.radius() + rounding_;

  std::vector<DBounds> boxes;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    add_pieces(patches_[i], static_cast<std::uint32_t>(i), {}, 0, boxes);
  }
  hierarchy_ = BezierHierarchy(boxes);
}

void BezierSurface::add_pieces(const BezierPatch& net, std::uint32_t patch, const BezierRect& rect,
                               int depth, std::vector<DBounds>& boxes) {
  const DBounds box = box_around(net);
  if (!spans_area(net, rounding_)) return;
  const BezierPiece piece(net, patch, rect, rounding_);
  if (depth == k_max_cuts || piece.is_flat()) {
    pieces_.push_back(piece);
    boxes.push_back({box.lower - 2.0 * rounding_, box.upper + 2.0 * rounding_});
    return;
  }
  const bool along_u = bends_along_u(net);
  const auto nets = halves(net, along_u);
  const auto rects = rect.halves(along_u);
  add_pieces(nets.first, patch, rects.first, depth + 1, boxes);
  add_pieces(nets.second, patch, rects.second, depth + 1, boxes);
}

std::optional<Crossing> BezierSurface::find(const ObjectRay& ray, bool any) const {
  const auto start = start_within(ray, middle_, radius_);
  if (!start || hierarchy_.root() == BezierHierarchy::k_none) return std::nullopt;
  BezierQuery query{.ray = ray, .start = *start, .rounding = rounding_, .any = any};
  const DVec3 inverse = inverse_of(ray.direction);
  // Loose by rounding: report() has the last word on the ray's ends.
  const double looseness = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(start->t);
  const double t_min = ray.t_min - start->t - looseness;
  double t_max = ray.t_max - start->t + looseness;

  struct Entry {
    std::uint32_t child;
    double enter;
  };
  // Clearing it would cost as much as a node.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  std::array<Entry, BezierHierarchy::k_max_depth + 1> stack;
  std::size_t count = 0;
  stack[count++] = {hierarchy_.root(), t_min};
  while (count > 0) {
    const Entry entry = stack[--count];
    if (!(entry.enter <= t_max)) continue;
    if ((entry.child & BezierHierarchy::k_piece) != 0) {
      const BezierPiece& piece = pieces_[entry.child & ~BezierHierarchy::k_piece];
      meet_piece(patches_[piece.patch], piece, query);
      if (!query.found) continue;
      if (query.any) break;
      t_max = query.closest.t - start->t + looseness;
      continue;
    }
    const BezierHierarchy::Node& node = hierarchy_.nodes()[entry.child];
    const Slabs hit = slabs(node, start->origin, inverse, t_min, t_max);
    const int near = hit.enter[1] < hit.enter[0] ? 1 : 0;
    const int far = 1 - near;
    if (hit.enter[far] <= hit.leave[far]) stack[count++] = {node.child[far], hit.enter[far]};
    if (hit.enter[near] <= hit.leave[near]) stack[count++] = {node.child[near], hit.enter[near]};
  }
  return query.found ? std::optional(query.closest) : std::nullopt;
}

std::optional<Crossing> BezierSurface::intersect(const ObjectRay& ray) const {
  return find(ray, false);
}

bool BezierSurface::meets(const ObjectRay& ray) const { return find(ray, true).has_value(); }

double BezierSurface::support(const DVec3& direction) const {
  double most = -std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, BezierHierarchy::k_max_depth + 1> stack{};
  std::size_t count = 0;
  if (hierarchy_.root() != BezierHierarchy::k_none) stack[count++] = hierarchy_.root();
  while (count > 0) {
    const std::uint32_t child = stack[--count];
    if ((child & BezierHierarchy::k_piece) != 0) {
      const BezierPiece& piece = pieces_[child & ~BezierHierarchy::k_piece];
      const BezierPatch net = part(patches_[piece.patch], piece.rect);
      for (const DVec3& p : net) most = std::max(most, dot(p, direction));
      continue;
    }
    const BezierHierarchy::Node& node = hierarchy_.nodes()[child];
    for (int side = 0; side < 2; ++side) {
      double bound = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        bound += std::max(direction[axis] * node.lower[axis][side],
                          direction[axis] * node.upper[axis][side]);
      }
      if (bound > most) stack[count++] = node.child[side];
    }
  }
  return most + rounding_ * length(direction);
}

ShapePoint BezierSurface::point(const DVec3& /*near*/, const Crossing& crossing) const {
  const BezierPatch& patch = patches_[crossing.part];
  const BezierPoint at = evaluate(patch, crossing.u, crossing.v);
  return {at.position,
          normal_at(patch, crossing.u, crossing.v),
          {crossing.u, crossing.v},
          at.du,
          at.dv};
}

}  // namespace lume::geometry
