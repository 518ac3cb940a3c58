// SPDX-License-Identifier: Apache-2.0
// Where a line meets a patch. Seen along the line the patch is a map F of its parameters into the
// plane, and a crossing is where F is 0. Let Y be the inverse of F's derivative in the middle of a
// rectangle. If the row sums of |Y F' - 1| stay below k < 1/3 in all of it, then
//  - F is injective, for F(p) - F(q) is an average of F' between the points, times p - q;
//  - a Newton step from p errs by at most 2 k / (1 - k) < 1 times the error of p, and clamping it
//    to the rectangle brings it no farther from a crossing that is inside.
// So the clamped iteration finds the crossing, or comes to rest at the edge if there is none. Other
// rectangles are cut in two until each is of this kind or its image excludes the origin.
#include "geometry/shapes/bezier_piece.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {
namespace {

using Net2 = BezierNet<DVec2>;

double cross2(const DVec2& a, const DVec2& b) { return a.x * b.y - a.y * b.x; }

/// Takes a crossing, the line's s = t - start.t, if it is on the ray and the closest so far.
void report(BezierQuery& query, double s, double u, double v, std::uint32_t patch) {
  const double t = query.start.t + s;
  if (!query.ray.contains(t) || !(t < query.closest.t || !query.found)) return;
  query.closest = {t, std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0), patch};
  query.found = true;
}

/// What is known of a map over a rectangle.
struct MapBounds {
  DVec2 du{0.0};  ///< mean derivatives
  DVec2 dv{0.0};
  bool is_regular = false;
  bool bends_along_u = false;  ///< whether cutting u brings it closer to being regular

  explicit MapBounds(const Net2& net) {
    for (std::size_t i = 0; i < 4; ++i) {
      du += 0.25 * (net[4 * i + 3] - net[4 * i]);
      dv += 0.25 * (net[12 + i] - net[i]);
    }
    const double determinant = std::abs(cross2(du, dv));
    // The rows of Y, times the determinant.
    DVec2 turn_u(0.0);
    DVec2 turn_v(0.0);
    for (std::size_t k = 0; k < 16; ++k) {
      if (k % 4 < 3) widen(turn_u, 3.0 * (net[k + 1] - net[k]) - du);
      if (k / 4 < 3) widen(turn_v, 3.0 * (net[k + 4] - net[k]) - dv);
    }
    const DVec2 turn = turn_u + turn_v;
    is_regular = determinant > 0.0 && std::max(turn.x, turn.y) <= k_regular * determinant;
    if (!is_regular) find_bend(net);
  }

 private:
  void widen(DVec2& bounds, const DVec2& v) const {
    bounds.x = std::max(bounds.x, std::abs(cross2(v, dv)));
    bounds.y = std::max(bounds.y, std::abs(cross2(du, v)));
  }

  /// Compares the second derivatives. Where the mixed one is the largest, as around a point into
  /// which an edge is collapsed, it is the longer side that has to be cut.
  void find_bend(const Net2& net) {
    DVec2 along_u(0.0);
    DVec2 along_v(0.0);
    DVec2 mixed(0.0);
    for (std::size_t k = 0; k < 16; ++k) {
      const bool has_u = k % 4 < 3;
      const bool has_v = k / 4 < 3;
      if (k % 4 < 2) widen(along_u, 6.0 * (net[k + 2] - 2.0 * net[k + 1] + net[k]));
      if (k / 4 < 2) widen(along_v, 6.0 * (net[k + 8] - 2.0 * net[k + 4] + net[k]));
      if (has_u && has_v) widen(mixed, 9.0 * (net[k + 5] - net[k + 4] - net[k + 1] + net[k]));
    }
    const double u = std::max(along_u.x, along_u.y);
    const double v = std::max(along_v.x, along_v.y);
    const bool is_twisted = std::max(mixed.x, mixed.y) >= std::max(u, v);
    bends_along_u = is_twisted ? dot(du, du) > dot(dv, dv) : u > v;
  }
};

class Search {
 public:
  Search(const BezierPatch& patch, std::uint32_t index, const BezierRect& rect, BezierQuery& query)
      : patch_(patch), index_(index), whole_(rect), query_(query) {
    const DVec3& d = query.ray.direction;
    const BezierPoint middle =
        evaluate(patch, rect.u + 0.5 * rect.width, rect.v + 0.5 * rect.height);
    const DVec3 away = middle.position - query.start.origin;
    const DVec3 nearest = query.start.origin + dot(away, d) / dot(d, d) * d;
    const DVec3 size = glm::abs(d);
    DVec3 axis(0.0);
    axis[size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2)] = 1.0;
    const DVec3 x = normalize(cross(d, axis));
    const DVec3 y = normalize(cross(d, x));
    Net2 net;
    for (std::size_t k = 0; k < 16; ++k) {
      const DVec3 p = patch[k] - nearest;
      net[k] = {dot(p, x), dot(p, y)};
    }
    net_ = part(net, rect);
    const DVec2 extent = box_around(net_).size();
    size_ = std::max(extent.x, extent.y);
  }

  void run() { visit(net_, whole_); }

 private:
  // The smallest rectangle and the smallest image of one, against the whole.
  static constexpr double k_smallest_rect = 0x1p-36;
  static constexpr double k_smallest_image = 0x1p-30;
  static constexpr double k_edge_on = 0x1p-12;

  void visit(const Net2& net, const BezierRect& rect) {
    if (steps_left_-- <= 0 || (query_.found && query_.any)) return;
    const double pad = query_.rounding;
    const auto [lower, upper] = box_around(net);
    if (lower.x > pad || lower.y > pad || upper.x < -pad || upper.y < -pad) return;
    const MapBounds shape(net);
    const double image_size = std::max(upper.x - lower.x, upper.y - lower.y);
    if (excludes_origin(net, shape, image_size)) return;

    const double u = rect.u + 0.5 * rect.width;
    const double v = rect.v + 0.5 * rect.height;
    if (shape.is_regular) {
      meet_regular(patch_, index_, rect, u, v, query_);
      return;
    }
    const bool is_u_small = rect.width <= k_smallest_rect * whole_.width;
    const bool is_v_small = rect.height <= k_smallest_rect * whole_.height;
    if (image_size <= k_smallest_image * size_ || (is_u_small && is_v_small)) {
      touch(u, v);
      return;
    }
    const bool along_u = is_v_small || (shape.bends_along_u && !is_u_small);
    const auto nets = halves(net, along_u);
    const auto rects = rect.halves(along_u);
    visit(nets.first, rects.first);
    visit(nets.second, rects.second);
  }

  /// Whether the image is to one side of the line through the origin along the image's longer
  /// derivative: near a silhouette the image of a rectangle is long and thin. A piece that is seen
  /// exactly edge-on is not met either, as no plane is by a line within it.
  [[nodiscard]] bool excludes_origin(const Net2& net, const MapBounds& shape,
                                     double image_size) const {
    const DVec2 along = dot(shape.du, shape.du) > dot(shape.dv, shape.dv) ? shape.du : shape.dv;
    double lower = cross2(along, net[0]);
    double upper = lower;
    for (const DVec2& p : net) {
      lower = std::min(lower, cross2(along, p));
      upper = std::max(upper, cross2(along, p));
    }
    const double pad = query_.rounding * length(along);
    if (lower > pad || upper < -pad) return true;
    return pad > 0.0 && lower >= -pad && upper <= pad && image_size > k_edge_on * size_;
  }

  /// A crossing that Newton's method cannot find: the line touches the surface there.
  void touch(double u, double v) {
    const DVec3& d = query_.ray.direction;
    const DVec3 p = evaluate(patch_, u, v).position - query_.start.origin;
    report(query_, dot(p, d) / dot(d, d), u, v, index_);
  }

  const BezierPatch& patch_;
  std::uint32_t index_;
  BezierRect whole_;
  BezierQuery& query_;
  Net2 net_{};
  double size_ = 0.0;      ///< of the whole image
  int steps_left_ = 1000;  ///< a bound of the time for a line that runs within a ruled surface
};

}  // namespace

void meet_regular(const BezierPatch& patch, std::uint32_t patch_index, const BezierRect& rect,
                  double u, double v, BezierQuery& query) {
  constexpr int k_max_steps = 30;
  constexpr double k_last_step = 1e-6;  // the step after it would be about the square of it
  constexpr double k_most = 1e-3;
  const DVec3& d = query.ray.direction;
  for (int step = 0; step < k_max_steps; ++step) {
    // S + S_u du + S_v dv = o + s d by Cramer's rule.
    const BezierPoint point = evaluate(patch, u, v);
    const DVec3 gap = point.position - query.start.origin;
    const DVec3 across_u = cross(point.dv, d);
    const DVec3 across_v = cross(d, point.du);
    const double inverse = 1.0 / dot(point.du, across_u);
    const double du = -dot(gap, across_u) * inverse;
    const double dv = -dot(gap, across_v) * inverse;

    // How far rounding moves the crossing, but never out of all proportion.
    const double noise = query.rounding * std::abs(inverse);
    const double slack_u =
        std::min(k_overlap * rect.width + noise * length(across_u), k_most * rect.width);
    const double slack_v =
        std::min(k_overlap * rect.height + noise * length(across_v), k_most * rect.height);
    const double next_u = std::clamp(u + du, rect.u, rect.u + rect.width);
    const double next_v = std::clamp(v + dv, rect.v, rect.v + rect.height);
    const bool is_inside =
        std::abs(next_u - (u + du)) <= slack_u && std::abs(next_v - (v + dv)) <= slack_v;
    if (is_inside && std::abs(du) <= std::max(k_last_step * rect.width, slack_u) &&
        std::abs(dv) <= std::max(k_last_step * rect.height, slack_v)) {
      const double s = dot(gap + du * point.du + dv * point.dv, d) / dot(d, d);
      report(query, s, u + du, v + dv, patch_index);
      return;
    }
    if (!is_inside && std::abs(next_u - u) <= k_last_step * rect.width &&
        std::abs(next_v - v) <= k_last_step * rect.height) {
      return;  // at rest at the edge
    }
    u = next_u;
    v = next_v;
  }
}

void meet_bent(const BezierPatch& patch, std::uint32_t patch_index, const BezierRect& rect,
               BezierQuery& query) {
  Search(patch, patch_index, rect, query).run();
}

}  // namespace lume::geometry
