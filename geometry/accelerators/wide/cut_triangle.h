// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/wide/reference.h"

#include <array>
#include <cmath>

namespace lume::geometry::wide {

[[nodiscard]] inline bool is_empty(const Box& box) {
  return (_mm_movemask_ps(_mm_cmple_ps(box.lower, box.upper)) & 7) != 7;
}

/// Cuts a triangle into slices between planes across an axis. `box` is around the part of it that
/// is still of interest. Slices are a little too large rather than too small, but never beyond the
/// box.
class TriangleCutter {
 public:
  TriangleCutter(const std::array<Vec3, 3>& corners, const Box& box, int axis)
      : box_(box), axis_(axis) {
    const __m128 sign = _mm_set1_ps(-0.0f);
    __m128 size = _mm_setzero_ps();
    for (int i = 0; i < 3; ++i) {
      points_[i] = _mm_setr_ps(corners[i].x, corners[i].y, corners[i].z, 0.0f);
      heights_[i] = corners[i][axis];
      size = _mm_max_ps(size, _mm_andnot_ps(sign, points_[i]));
    }
    slack_ = _mm_mul_ps(size, _mm_set1_ps(0x1p-21f));
  }

  /// Around the slice low <= p[axis] <= high, of which either may be infinite.
  [[nodiscard]] Box between(float low, float high) const {
    Box slice;
    for (int i = 0; i < 3; ++i) {
      if (heights_[i] >= low && heights_[i] <= high) slice.add_point(points_[i]);
      const int next = i == 2 ? 0 : i + 1;
      add_crossing(i, next, low, slice);
      add_crossing(i, next, high, slice);
    }
    return {_mm_max_ps(_mm_sub_ps(slice.lower, slack_), within(box_.lower, low, true)),
            _mm_min_ps(_mm_add_ps(slice.upper, slack_), within(box_.upper, high, false))};
  }

 private:
  void add_crossing(int from, int to, float plane, Box& slice) const {
    const float a = heights_[from];
    const float b = heights_[to];
    if (!((a < plane && b > plane) || (a > plane && b < plane))) return;
    const float along = (plane - a) / (b - a);
    slice.add_point(_mm_add_ps(
        points_[from], _mm_mul_ps(_mm_sub_ps(points_[to], points_[from]), _mm_set1_ps(along))));
  }

  /// A corner of the box, moved inwards to the plane.
  [[nodiscard]] __m128 within(__m128 corner, float plane, bool lower) const {
    alignas(16) float values[4];
    _mm_store_ps(values, corner);
    values[axis_] = lower ? std::fmax(values[axis_], plane) : std::fmin(values[axis_], plane);
    return _mm_load_ps(values);
  }

  Box box_;
  int axis_;
  __m128 points_[3];
  float heights_[3];
  __m128 slack_;  ///< more than rounding can move a crossing: some 2^-23 of the largest coordinate
};

}  // namespace lume::geometry::wide
