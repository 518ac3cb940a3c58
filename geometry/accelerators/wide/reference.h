// SPDX-License-Identifier: Apache-2.0
// What the builder sorts: boxes with the number of the item in them, in SSE registers, since a
// build looks at each of them some hundred times.
#pragma once

#include "geometry/bounds.h"

#include <immintrin.h>

#include <cstdint>
#include <limits>

namespace lume::geometry::wide {

/// A box in two registers; the fourth lanes mean nothing.
struct Box {
  __m128 lower = _mm_set1_ps(std::numeric_limits<float>::infinity());
  __m128 upper = _mm_set1_ps(-std::numeric_limits<float>::infinity());

  void add(const Box& other) {
    lower = _mm_min_ps(lower, other.lower);
    upper = _mm_max_ps(upper, other.upper);
  }
  void add_point(__m128 point) {
    lower = _mm_min_ps(lower, point);
    upper = _mm_max_ps(upper, point);
  }
  /// Half the area of the surface, in double because sizes may be near a float's end; 0 of an empty
  /// box.
  [[nodiscard]] double half_area() const {
    alignas(16) float size[4];
    _mm_store_ps(size, _mm_max_ps(_mm_sub_ps(upper, lower), _mm_setzero_ps()));
    const double x = size[0];
    const double y = size[1];
    const double z = size[2];
    return x * y + y * z + z * x;
  }
};

/// Three of four floats, the last made 0: what else is there might be slow to compute with.
inline __m128 load3(const float* x) { return _mm_blend_ps(_mm_load_ps(x), _mm_setzero_ps(), 8); }

/// A box and what is in it: 32 bytes.
struct alignas(16) Reference {
  float lower[3];
  std::uint32_t item;
  float upper[3];
  std::uint32_t splits;  ///< how many more times it may be cut

  [[nodiscard]] Box box() const { return {load3(lower), load3(upper)}; }
  void set_box(const Box& box) {
    alignas(16) float values[4];
    _mm_store_ps(values, box.lower);
    for (int axis = 0; axis < 3; ++axis) lower[axis] = values[axis];
    _mm_store_ps(values, box.upper);
    for (int axis = 0; axis < 3; ++axis) upper[axis] = values[axis];
  }
};

inline Reference make_reference(const Bounds& bounds, std::uint32_t item) {
  return {{bounds.lower.x, bounds.lower.y, bounds.lower.z},
          item,
          {bounds.upper.x, bounds.upper.y, bounds.upper.z},
          0};
}

/// Halved before it is added, so that nothing overflows.
inline __m128 middle(const Box& box) {
  const __m128 half = _mm_set1_ps(0.5f);
  return _mm_add_ps(_mm_mul_ps(box.lower, half), _mm_mul_ps(box.upper, half));
}

}  // namespace lume::geometry::wide
