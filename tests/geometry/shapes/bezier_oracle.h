// SPDX-License-Identifier: Apache-2.0
// The first point of a ray on Bezier patches by nothing but halving: a part of a patch whose
// control points are all to one side of the ray holds none. In 64-bit arithmetic, and shares no
// code with the surface under test.
#pragma once

#include "geometry/crossing.h"
#include "geometry/shapes/bezier_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lume::test {

class BezierOracle {
 public:
  /// Halves `levels` times along u and along v, so that (u, v) is known to 2^-levels of a patch.
  BezierOracle(const std::vector<geometry::BezierPatch>& patches, const geometry::ObjectRay& ray,
               int levels)
      : cuts_(2 * levels), t_min_(ray.t_min), t_max_(ray.t_max) {
    const Vector d = make(ray.direction);
    speed_ = std::sqrt(dot(d, d));
    // The origin moves beside the surface, rounded once, or digits would be lost far away.
    const Vector away = subtract(make(patches.at(0)[0]), make(ray.origin));
    shift_ = dot(away, d) / dot(d, d);
    Vector o{};
    for (int i = 0; i < 3; ++i) {
      const long double origin = ray.origin[i];
      o[static_cast<std::size_t>(i)] = std::fma(shift_, d[static_cast<std::size_t>(i)], origin);
    }
    z_ = scaled(d, 1 / speed_);
    const Vector aside = std::abs(z_[0]) < 0.6L ? Vector{1, 0, 0} : Vector{0, 1, 0};
    x_ = cross(z_, aside);
    x_ = scaled(x_, 1 / std::sqrt(dot(x_, x_)));
    y_ = cross(z_, x_);
    for (const geometry::BezierPatch& patch : patches) {
      Net net;
      for (std::size_t k = 0; k < 16; ++k) {
        const Vector p = subtract(make(patch[k]), o);
        net[k] = {dot(x_, p), dot(y_, p), dot(z_, p)};
      }
      visit(net, 0);
    }
  }

  bool hit = false;
  long double t = 0;
  geometry::DVec3 normal{0.0};  ///< unit, dS/dv x dS/du

 private:
  using Vector = std::array<long double, 3>;
  using Net = std::array<Vector, 16>;

  static Vector make(const geometry::DVec3& v) { return {v.x, v.y, v.z}; }
  static Vector subtract(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Vector scaled(const Vector& a, long double s) { return {s * a[0], s * a[1], s * a[2]}; }
  static long double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  [[nodiscard]] long double time_at(long double z) const { return shift_ + z / speed_; }

  /// Replaces the curve's four control points by those of its two halves.
  static void halve(const Net& net, std::size_t at, std::size_t step, Net& first, Net& second) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto p = [&](std::size_t i) { return net[at + i * step][axis]; };
      const long double ab = (p(0) + p(1)) / 2;
      const long double bc = (p(1) + p(2)) / 2;
      const long double cd = (p(2) + p(3)) / 2;
      const long double abc = (ab + bc) / 2;
      const long double bcd = (bc + cd) / 2;
      const long double middle = (abc + bcd) / 2;
      const long double parts[7] = {p(0), ab, abc, middle, bcd, cd, p(3)};
      for (std::size_t i = 0; i < 4; ++i) {
        first[at + i * step][axis] = parts[i];
        second[at + i * step][axis] = parts[3 + i];
      }
    }
  }

  void visit(const Net& net, int depth) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto is_above = [axis](const Vector& p) { return p[axis] > 0; };
      const auto is_below = [axis](const Vector& p) { return p[axis] < 0; };
      if (std::all_of(net.begin(), net.end(), is_above)) return;
      if (std::all_of(net.begin(), net.end(), is_below)) return;
    }
    long double near = net[0][2];
    long double far = net[0][2];
    for (const Vector& p : net) {
      near = std::min(near, p[2]);
      far = std::max(far, p[2]);
    }
    if (time_at(far) < t_min_ || time_at(near) > t_max_ || (hit && time_at(near) >= t)) return;
    if (depth == cuts_) {
      take(net, near, far);
      return;
    }
    Net first;
    Net second;
    const bool along_u = depth % 2 == 0;
    for (std::size_t curve = 0; curve < 4; ++curve) {
      halve(net, along_u ? 4 * curve : curve, along_u ? 1 : 4, first, second);
    }
    const bool is_swapped = second[0][2] < first[0][2];
    visit(is_swapped ? second : first, depth + 1);
    visit(is_swapped ? first : second, depth + 1);
  }

  /// The last part is flat: the ray meets the plane through its corners.
  void take(const Net& net, long double near, long double far) {
    const Vector n = cross(subtract(net[12], net[0]), subtract(net[3], net[0]));
    const long double on_plane = dot(n, net[0]) / n[2];
    const long double here = time_at(on_plane >= near && on_plane <= far ? on_plane : near);
    if (here < t_min_ || here > t_max_ || (hit && here >= t)) return;
    hit = true;
    t = here;
    const long double size = std::sqrt(dot(n, n));
    for (std::size_t i = 0; i < 3; ++i) {
      normal[static_cast<int>(i)] =
          static_cast<double>((n[0] * x_[i] + n[1] * y_[i] + n[2] * z_[i]) / size);
    }
  }

  int cuts_;
  long double t_min_;
  long double t_max_;
  long double shift_ = 0;  ///< the ray's t of the origin
  Vector x_{};             ///< a frame whose z runs along the ray
  Vector y_{};
  Vector z_{};
  long double speed_ = 0;
};

}  // namespace lume::test
