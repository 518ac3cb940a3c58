// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/split.h"

#include "geometry/accelerators/wide/cut_triangle.h"
#include "geometry/parallel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace lume::geometry::wide {
namespace {

constexpr int k_most_bins = 32;
constexpr int k_spatial_bins = 16;

/// What lies in the bins along the three axes. A reference in several bins begins in the first and
/// ends in the last.
struct Bins {
  explicit Bins(int bin_count) {
    for (int axis = 0; axis < 3; ++axis) {
      std::fill_n(boxes[axis], bin_count, Box());
      std::fill_n(begins[axis], bin_count, 0u);
      std::fill_n(ends[axis], bin_count, 0u);
    }
  }
  void merge(const Bins& other, int bin_count) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < bin_count; ++i) {
        boxes[axis][i].add(other.boxes[axis][i]);
        begins[axis][i] += other.begins[axis][i];
        ends[axis][i] += other.ends[axis][i];
      }
    }
  }

  Box boxes[3][k_most_bins];
  std::uint32_t begins[3][k_most_bins];
  std::uint32_t ends[3][k_most_bins];
};

std::array<float, 4> values(__m128 x) {
  alignas(16) std::array<float, 4> result;
  _mm_store_ps(result.data(), x);
  return result;
}

/// The cheapest plane between bins.
Split best_plane(const Bins& bins, int bin_count, const BinMap& map) {
  Split best{.cost = std::numeric_limits<double>::infinity(), .map = map};
  const auto scale = values(map.scale);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(scale[axis] > 0.0f)) continue;
    std::array<Box, k_most_bins> box_from;  // of all bins from i on
    std::array<double, k_most_bins> cost_from{};
    Box box;
    std::size_t count = 0;
    for (int i = bin_count - 1; i > 0; --i) {
      box.add(bins.boxes[axis][i]);
      count += bins.ends[axis][i];
      box_from[i] = box;
      cost_from[i] = count == 0 ? std::numeric_limits<double>::infinity()
                                : box.half_area() * block_count(count);
    }
    box = Box();
    count = 0;
    for (int i = 1; i < bin_count; ++i) {
      box.add(bins.boxes[axis][i - 1]);
      count += bins.begins[axis][i - 1];
      if (count == 0) continue;
      const double cost = box.half_area() * block_count(count) + cost_from[i];
      if (!(cost < best.cost)) continue;
      best.cost = cost;
      best.axis = axis;
      best.bin = i;
      const Box common{_mm_max_ps(box.lower, box_from[i].lower),
                       _mm_min_ps(box.upper, box_from[i].upper)};
      best.overlap = common.half_area();
    }
  }
  return best;
}

void bin_middles(std::span<const Reference> references, const BinMap& map, Bins& bins) {
  for (const Reference& reference : references) {
    const Box box = reference.box();
    alignas(16) int bin[4];
    _mm_store_si128(reinterpret_cast<__m128i*>(bin), map.bins(middle(box)));
    for (int axis = 0; axis < 3; ++axis) {
      bins.boxes[axis][bin[axis]].add(box);
      ++bins.begins[axis][bin[axis]];
    }
  }
}

/// Calls `bin(part, bins)` for parts of the range, on several threads if it is large, and adds up.
template <class Bin>
Bins bin_all(const Range& range, int bin_count, const Bin& bin) {
  constexpr std::size_t k_part = 1u << 15u;
  const std::size_t parts = (range.count + k_part - 1) / k_part;
  Bins bins(bin_count);
  if (parts < 4) {
    bin(range.references(), bins);
    return bins;
  }
  std::vector<Bins> of_part(parts, bins);
  parallel_for(parts, [&](std::size_t i) {
    const std::size_t first = i * k_part;
    bin(range.references().subspan(first, std::min(k_part, range.count - first)), of_part[i]);
  });
  for (const Bins& part : of_part) bins.merge(part, bin_count);
  return bins;
}

/// A triangle that may still be cut goes into each bin it reaches, cut to it; all else into the bin
/// of its middle.
void bin_parts(std::span<const Reference> references, const BinMap& map, const TriangleItems& items,
               Bins& bins) {
  for (const Reference& reference : references) {
    const Box box = reference.box();
    alignas(16) int first[4];
    alignas(16) int last[4];
    const bool whole = reference.splits == 0;
    const __m128 at = middle(box);
    _mm_store_si128(reinterpret_cast<__m128i*>(first), map.bins(whole ? at : box.lower));
    _mm_store_si128(reinterpret_cast<__m128i*>(last), map.bins(whole ? at : box.upper));
    for (int axis = 0; axis < 3; ++axis) {
      ++bins.begins[axis][first[axis]];
      ++bins.ends[axis][last[axis]];
      if (first[axis] == last[axis]) {
        bins.boxes[axis][first[axis]].add(box);
        continue;
      }
      const TriangleCutter cutter(items.corners(reference.item), box, axis);
      for (int bin = first[axis]; bin <= last[axis]; ++bin) {
        constexpr float k_infinity = std::numeric_limits<float>::infinity();
        const float low = bin == first[axis] ? -k_infinity : map.plane(bin, axis);
        const float high = bin == last[axis] ? k_infinity : map.plane(bin + 1, axis);
        bins.boxes[axis][bin].add(cutter.between(low, high));
      }
    }
  }
}

/// Cuts what reaches over the plane in two while there is room; returns how many there are then.
std::size_t cut_references(const Range& range, const Split& split, const TriangleItems& items) {
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  const float plane = split.map.plane(split.bin, split.axis);
  std::size_t count = range.count;
  for (std::size_t i = 0; i < range.count && count < range.count + range.room; ++i) {
    Reference& reference = range.begin[i];
    if (reference.splits == 0) continue;
    const Box box = reference.box();
    const bool reaches_over = split.map.bin(box.lower, split.axis) < split.bin &&
                              split.map.bin(box.upper, split.axis) >= split.bin;
    if (!reaches_over) continue;
    const TriangleCutter cutter(items.corners(reference.item), box, split.axis);
    const Box left = cutter.between(-k_infinity, plane);
    const Box right = cutter.between(plane, k_infinity);
    if (is_empty(left) || is_empty(right)) continue;
    --reference.splits;
    range.begin[count] = reference;
    range.begin[count++].set_box(right);
    reference.set_box(left);
  }
  return count;
}

void add(Range& range, const Reference& reference) {
  const Box box = reference.box();
  range.box.add(box);
  range.middles.add_point(middle(box));
  range.cuttable += reference.splits > 0 ? 1 : 0;
}

/// Left ones first; completes both sides' boxes.
void partition(const Split& split, Range& left, Range& right, Reference* end) {
  Reference* front = left.begin;
  Reference* back = end;
  while (front < back) {
    if (split.map.bin(middle(front->box()), split.axis) < split.bin) {
      add(left, *front);
      ++front;
    } else {
      add(right, *front);
      std::swap(*front, *--back);
    }
  }
  right.begin = front;
}

void halve(Range& left, Range& right, std::size_t count) {
  right.begin = left.begin + count / 2;
  for (Reference* i = left.begin; i < left.begin + count; ++i) {
    add(i < right.begin ? left : right, *i);
  }
}

}  // namespace

BinMap::BinMap(const Box& middles, int bin_count) : lower(middles.lower) {
  const auto low = values(middles.lower);
  const auto high = values(middles.upper);
  alignas(16) float scales[4] = {};
  for (int axis = 0; axis < 3; ++axis) {
    // In double: the size of a box may be more than a float holds.
    const double size = static_cast<double>(high[axis]) - static_cast<double>(low[axis]);
    const auto s = static_cast<float>(0.99999 * bin_count / size);
    scales[axis] = size > 0.0 && s < std::numeric_limits<float>::max() ? s : 0.0f;
  }
  scale = _mm_load_ps(scales);
  last = _mm_set1_epi32(bin_count - 1);
}

float BinMap::plane(int i, int axis) const {
  return values(lower)[axis] + static_cast<float>(i) / values(scale)[axis];
}

Split find_object_split(const Range& range) {
  // Few references fill few bins.
  const int bin_count = static_cast<int>(std::min<std::size_t>(k_most_bins, 4 + range.count / 4));
  const BinMap map(range.middles, bin_count);
  Bins bins = bin_all(range, bin_count, [&](std::span<const Reference> part, Bins& sums) {
    bin_middles(part, map, sums);
  });
  std::copy_n(&bins.begins[0][0], 3 * k_most_bins, &bins.ends[0][0]);
  return best_plane(bins, bin_count, map);
}

Split find_spatial_split(const Range& range, const TriangleItems& items) {
  const BinMap map(range.box, k_spatial_bins);
  const Bins bins = bin_all(
      range, k_spatial_bins,
      [&](std::span<const Reference> part, Bins& sums) { bin_parts(part, map, items, sums); });
  Split split = best_plane(bins, k_spatial_bins, map);
  split.is_spatial = true;
  return split;
}

std::pair<Range, Range> apply_split(const Range& range, const Split& split,
                                    const TriangleItems* items) {
  std::size_t count = range.count;
  if (split.is_spatial) count = cut_references(range, split, *items);
  Range left;
  Range right;
  left.begin = range.begin;
  left.depth = right.depth = range.depth;
  if (split.axis >= 0) partition(split, left, right, range.begin + count);
  if (split.axis < 0 || right.begin == left.begin || right.begin == range.begin + count) {
    left.box = right.box = left.middles = right.middles = Box();
    left.cuttable = right.cuttable = 0;
    halve(left, right, count);
  }
  left.count = static_cast<std::size_t>(right.begin - left.begin);
  right.count = count - left.count;
  // The room that is left is for both sides, as they have references.
  const std::size_t room = range.room - (count - range.count);
  left.room = room * left.count / count;
  right.room = room - left.room;
  if (left.room > 0) {
    std::move_backward(right.begin, right.begin + right.count,
                       right.begin + right.count + left.room);
    right.begin += left.room;
  }
  return {left, right};
}

}  // namespace lume::geometry::wide
