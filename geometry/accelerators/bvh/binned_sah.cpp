// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/binned_sah.h"

#include "geometry/accelerators/bvh/median.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lume::geometry::bvh {
namespace {

struct Bin {
  Bounds box;
  std::uint32_t count = 0;

  void add(const Bin& other) {
    box.add(other.box);
    count += other.count;
  }
  [[nodiscard]] double cost() const { return half_area(box) * count; }
};

using Bins = std::array<Bin, k_bins>;

/// Puts the cheapest of the planes between the bins of one axis into `best` if it is cheaper still.
void try_planes(const Bins& bins, int count, int axis, BinSplit& best) {
  std::array<Bin, k_bins> above{};  // all bins from here on
  Bin side;
  for (int i = count - 1; i > 0; --i) {
    side.add(bins[i]);
    above[i] = side;
  }
  side = {};
  for (int i = 1; i < count; ++i) {
    side.add(bins[i - 1]);
    if (side.count == 0 || above[i].count == 0) continue;
    const double cost = side.cost() + above[i].cost();
    if (cost < best.cost) best = {cost, axis, i, side.box, above[i].box};
  }
}

std::size_t split_by_bins(std::span<Entry> entries, int depth) {
  if (depth >= k_free_depth) return entries.size() > k_most_in_leaf ? halve(entries) : 0;
  const CentroidBins bins(entries);
  const BinSplit best = find_split(entries, bins);
  Bounds box = best.left;
  box.add(best.right);
  switch (advise(entries.size(), half_area(box), best.cost)) {
    case Advice::keep_together:
      return 0;
    case Advice::split:
      return part(entries, bins, best);
    case Advice::split_anyhow:
      break;
  }
  return halve(entries);
}

}  // namespace

CentroidBins::CentroidBins(std::span<const Entry> entries)
    : count_(static_cast<int>(std::min<std::size_t>(k_bins, 2 * entries.size()))) {
  const DBounds centroids = centroid_bounds(entries);
  lower_ = centroids.lower;
  for (int axis = 0; axis < 3; ++axis) {
    const double scale = count_ / centroids.size()[axis];
    scale_[axis] = std::isfinite(scale) ? scale : 0.0;
  }
}

BinSplit find_split(std::span<const Entry> entries, const CentroidBins& bins) {
  std::array<Bins, 3> by_axis{};
  for (const Entry& entry : entries) {
    for (int axis = 0; axis < 3; ++axis) {
      by_axis[axis][bins.bin_of(entry, axis)].add({entry.box, 1});
    }
  }
  BinSplit best;
  for (int axis = 0; axis < 3; ++axis) {
    if (bins.can_split(axis)) try_planes(by_axis[axis], bins.count(), axis, best);
  }
  return best;
}

std::size_t part(std::span<Entry> entries, const CentroidBins& bins, const BinSplit& split) {
  const auto second = std::partition(entries.begin(), entries.end(), [&](const Entry& entry) {
    return bins.bin_of(entry, split.axis) < split.bin;
  });
  return static_cast<std::size_t>(second - entries.begin());
}

Advice advise(std::size_t count, double half_area, double split_cost) {
  const double leaf_cost = half_area * static_cast<double>(count);
  if (count <= k_most_in_leaf) {
    return leaf_cost <= half_area + split_cost ? Advice::keep_together : Advice::split;
  }
  return split_cost < leaf_cost ? Advice::split : Advice::split_anyhow;
}

BinaryTree build_binned_sah(const Items& items) {
  std::vector<Entry> list = list_entries(items);
  return build_top_down(items, list, split_by_bins);
}

}  // namespace lume::geometry::bvh
