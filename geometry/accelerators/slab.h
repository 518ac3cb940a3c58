// SPDX-License-Identifier: Apache-2.0
// A ray against a box as the overlap of three slabs (Kay and Kajiya 1986, "Ray Tracing Complex
// Scenes"), so that no ray misses the box of something that it meets.
#pragma once

#include "geometry/bounds.h"
#include "geometry/crossing.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {

/// The part of a ray that is inside a box; empty if enter > leave.
struct Interval1D {
  double enter = 0.0;
  double leave = 0.0;

  [[nodiscard]] bool is_empty() const { return !(enter <= leave); }
};

/// How far from its place along an axis a plane of a structure inside `all` may seem to a ray, with
/// what is rounded on the way there and in the tests of what is behind it (length of object space).
[[nodiscard]] inline double slab_slack(const ObjectRay& ray, const Bounds& all, int axis) {
  constexpr double k_rounding = 1e-13;
  return k_rounding *
         (std::abs(ray.origin[axis]) + std::max(std::abs(static_cast<double>(all.lower[axis])),
                                                std::abs(static_cast<double>(all.upper[axis]))));
}

/// A ray made ready for the boxes of one structure. A plane x = p is crossed at t = p / d - o / d.
/// What is rounded there, and what the test of the primitive itself has rounded, is added once for
/// all boxes: each of them is met a little before it begins and left a little after it ends, by
/// some 1e-13 of the distance from the origin to the structure's far side (after Ize 2013, "Robust
/// BVH Ray Traversal", JCGT 2(2), who widens every interval on its own).
class SlabRay {
 public:
  /// `all` is around every box that will be asked.
  SlabRay(const ObjectRay& ray, const Bounds& all) {
    for (int axis = 0; axis < 3; ++axis) {
      // A ray that runs along the slab for all its length is as good as one that hardly turns.
      constexpr double k_flattest = 1e-150;
      const double d = std::abs(ray.direction[axis]) < k_flattest
                           ? std::copysign(k_flattest, ray.direction[axis])
                           : ray.direction[axis];
      const double inverse = 1.0 / d;
      const double slack = slab_slack(ray, all, axis) * std::abs(inverse);
      inverse_[axis] = inverse;
      near_[axis] = -ray.origin[axis] * inverse - slack;
      far_[axis] = -ray.origin[axis] * inverse + slack;
      backwards_[axis] = d < 0.0;
    }
  }

  /// Where the ray is inside the box, of the part [t_min, t_max].
  [[nodiscard]] Interval1D clip(const Bounds& box, double t_min, double t_max) const {
    Interval1D result{t_min, t_max};
    for (int axis = 0; axis < 3; ++axis) {
      const auto lower = static_cast<double>(box.lower[axis]);
      const auto upper = static_cast<double>(box.upper[axis]);
      const double first = backwards_[axis] ? upper : lower;
      const double last = backwards_[axis] ? lower : upper;
      result.enter = std::max(result.enter, first * inverse_[axis] + near_[axis]);
      result.leave = std::min(result.leave, last * inverse_[axis] + far_[axis]);
    }
    return result;
  }

  /// When the ray crosses the plane at `place` on an axis: no earlier than the one, and no later
  /// than the other.
  [[nodiscard]] double earliest(int axis, double place) const {
    return place * inverse_[axis] + near_[axis];
  }
  [[nodiscard]] double latest(int axis, double place) const {
    return place * inverse_[axis] + far_[axis];
  }

  /// Whether the ray runs towards lower coordinates.
  [[nodiscard]] bool backwards(int axis) const { return backwards_[axis]; }

 private:
  DVec3 inverse_{0.0};
  DVec3 near_{0.0};
  DVec3 far_{0.0};
  bool backwards_[3] = {};
};

}  // namespace lume::geometry
