// SPDX-License-Identifier: Apache-2.0
// The surface area heuristic at the price of a few passes: items are counted in bins along each
// axis, and only the planes between bins are tried (Wald 2007, "On fast Construction of SAH-based
// Bounding Volume Hierarchies").
#pragma once

#include "geometry/accelerators/bvh/top_down.h"

#include <algorithm>
#include <limits>

namespace lume::geometry::bvh {

/// Few bins cannot see a teapot in a stadium: all of it falls into one.
inline constexpr int k_bins = 32;

/// Sorts items into bins between the outermost centroids.
class CentroidBins {
 public:
  explicit CentroidBins(std::span<const Entry> entries);

  /// Whether there is anything to tell apart along the axis.
  [[nodiscard]] bool can_split(int axis) const { return scale_[axis] > 0.0; }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int bin_of(const Entry& entry, int axis) const {
    const double place = (entry.twice_centroid(axis) - lower_[axis]) * scale_[axis];
    return std::min(static_cast<int>(place), count_ - 1);
  }

 private:
  DVec3 lower_{0.0};
  DVec3 scale_{0.0};  ///< bins per length; 0 along axes without any
  int count_ = 0;
};

/// A way to part items in two by a plane between bins.
struct BinSplit {
  /// Each side's half area times its number of items: their part of the expected cost, but for the
  /// root's half area, by which all costs would be divided. Infinite: there is no such plane.
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  int bin = 0;         ///< the first of the second side
  Bounds left, right;  ///< around the items of each side
};

/// The cheapest one.
[[nodiscard]] BinSplit find_split(std::span<const Entry> entries, const CentroidBins& bins);

/// Puts the items of the first side first. Returns how many there are.
std::size_t part(std::span<Entry> entries, const CentroidBins& bins, const BinSplit& split);

/// What the surface area heuristic says to a number of items in a box.
enum class Advice { keep_together, split, split_anyhow };

/// `split_cost` is that of the best way to part them (see BinSplit::cost). Where no split is of
/// use, but there are too many to stay together, how they are split does not matter.
[[nodiscard]] Advice advise(std::size_t count, double half_area, double split_cost);

[[nodiscard]] BinaryTree build_binned_sah(const Items& items);

}  // namespace lume::geometry::bvh
