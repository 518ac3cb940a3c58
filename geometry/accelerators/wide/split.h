// SPDX-License-Identifier: Apache-2.0
// Where to cut a set of references in two: the cheapest of the planes between bins, either around
// whole references (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies") or
// through them (Stich, Friedrich and Dietrich 2009, "Spatial Splits in Bounding Volume
// Hierarchies").
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/accelerators/wide/reference.h"

#include <cstddef>
#include <span>

namespace lume::geometry::wide {

/// References that stand side by side, with room behind them for those that cuts add.
struct Range {
  Reference* begin = nullptr;
  std::size_t count = 0;
  std::size_t room = 0;      ///< how many more there may be
  std::size_t cuttable = 0;  ///< how many may be cut
  Box box;
  Box middles;  ///< around the middles of the references' boxes
  std::size_t depth = 0;

  [[nodiscard]] std::span<Reference> references() const { return {begin, count}; }
};

/// From a middle to the number of its bin, along all axes at once.
struct BinMap {
  BinMap() = default;
  BinMap(const Box& middles, int bin_count);

  /// The bins of a point, below bin_count; the fourth number means nothing.
  [[nodiscard]] __m128i bins(__m128 point) const {
    const __m128 place = _mm_mul_ps(_mm_sub_ps(point, lower), scale);
    return _mm_min_epi32(_mm_max_epi32(_mm_cvttps_epi32(place), _mm_setzero_si128()), last);
  }
  [[nodiscard]] int bin(__m128 point, int axis) const {
    alignas(16) int values[4];
    _mm_store_si128(reinterpret_cast<__m128i*>(values), bins(point));
    return values[axis];
  }
  /// Where bin i begins.
  [[nodiscard]] float plane(int i, int axis) const;

  __m128 lower = _mm_setzero_ps();
  __m128 scale = _mm_setzero_ps();  ///< 0 along an axis that cannot be cut
  __m128i last = _mm_setzero_si128();
};

/// A plane, and what it would cost: areas times blocks of four triangles.
struct Split {
  double cost = 0.0;
  int axis = -1;  ///< none: there is no such plane
  int bin = 0;    ///< the first bin beyond the plane
  bool is_spatial = false;
  BinMap map;
  double overlap = 0.0;  ///< half the area of what the boxes on both sides have in common
};

/// Tests of blocks that `count` triangles take.
[[nodiscard]] inline double block_count(std::size_t count) {
  return static_cast<double>((count + 3) / 4);
}

/// Around whole references. On several threads if the range is large, which changes nothing.
[[nodiscard]] Split find_object_split(const Range& range);
/// Through triangles.
[[nodiscard]] Split find_spatial_split(const Range& range, const TriangleItems& items);

/// Moves what is beyond the split behind the rest and returns both sides. Cuts references in two as
/// far as there is room. Without a plane each side gets half of them.
[[nodiscard]] std::pair<Range, Range> apply_split(const Range& range, const Split& split,
                                                  const TriangleItems* items);

}  // namespace lume::geometry::wide
