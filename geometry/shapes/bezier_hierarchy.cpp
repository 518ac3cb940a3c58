// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/bezier_hierarchy.h"

#include <algorithm>
#include <limits>

namespace lume::geometry {
namespace {

/// Half the area of the surface; 0 of an empty box.
double half_area(const DBounds& box) {
  const DVec3 size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

constexpr int k_bins = 16;

/// The cheapest of the planes between bins along one axis (Wald 2007, "On fast Construction of
/// SAH-based Bounding Volume Hierarchies"): its cost, and the first bin beyond it.
std::pair<double, int> best_plane(const std::array<DBounds, k_bins>& boxes,
                                  const std::array<std::size_t, k_bins>& counts) {
  std::array<double, k_bins> cost_below{};
  DBounds box;
  std::size_t count = 0;
  for (int i = 0; i + 1 < k_bins; ++i) {
    box.add(boxes[i]);
    count += counts[i];
    cost_below[i + 1] = half_area(box) * static_cast<double>(count);
  }
  std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
  box = {};
  count = 0;
  for (int i = k_bins - 1; i > 0; --i) {
    box.add(boxes[i]);
    count += counts[i];
    const double cost = cost_below[i] + half_area(box) * static_cast<double>(count);
    if (cost < best.first) best = {cost, i};
  }
  return best;
}

}  // namespace

BezierHierarchy::BezierHierarchy(const std::vector<DBounds>& boxes) {
  std::vector<Item> items;
  items.reserve(boxes.size());
  for (const DBounds& box : boxes) {
    items.push_back({box, box.center(), static_cast<std::uint32_t>(items.size())});
  }
  if (items.empty()) return;
  nodes_.reserve(items.size() - 1);
  root_ = build(items, {0, items.size()}, 0);
}

std::uint32_t BezierHierarchy::build(std::vector<Item>& items, Range range, int depth) {
  if (range.second - range.first == 1) return items[range.first].piece | k_piece;
  const std::size_t middle = split(items, range, depth);
  const Range halves[2] = {{range.first, middle}, {middle, range.second}};
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  for (int side = 0; side < 2; ++side) {
    DBounds box;
    for (std::size_t i = halves[side].first; i < halves[side].second; ++i) box.add(items[i].box);
    for (int axis = 0; axis < 3; ++axis) {
      nodes_[index].lower[axis][side] = box.lower[axis];
      nodes_[index].upper[axis][side] = box.upper[axis];
    }
    const std::uint32_t child = build(items, halves[side], depth + 1);
    nodes_[index].child[side] = child;
  }
  return index;
}

std::size_t BezierHierarchy::split(std::vector<Item>& items, Range range, int depth) {
  DBounds middles;
  for (std::size_t i = range.first; i < range.second; ++i) middles.add(items[i].middle);
  const DVec3 size = middles.size();
  const auto bin_of = [&](const Item& item, int axis) {
    const double place = (item.middle[axis] - middles.lower[axis]) / size[axis];
    return std::min(static_cast<int>(place * k_bins), k_bins - 1);
  };
  double least = std::numeric_limits<double>::infinity();
  int best_axis = -1;
  int best_bin = 0;
  // Medians halve the number of pieces, so that the depth stays below k_max_depth.
  for (int axis = 0; axis < 3 && depth < k_max_depth / 2; ++axis) {
    if (!(size[axis] > 0.0)) continue;
    std::array<DBounds, k_bins> boxes{};
    std::array<std::size_t, k_bins> counts{};
    for (std::size_t i = range.first; i < range.second; ++i) {
      const int bin = bin_of(items[i], axis);
      boxes[bin].add(items[i].box);
      ++counts[bin];
    }
    const auto [cost, bin] = best_plane(boxes, counts);
    if (cost >= least) continue;
    least = cost;
    best_axis = axis;
    best_bin = bin;
  }
  const auto begin = items.begin();
  const auto first = begin + static_cast<std::ptrdiff_t>(range.first);
  const auto last = begin + static_cast<std::ptrdiff_t>(range.second);
  if (best_axis >= 0) {
    const auto cut = std::partition(
        first, last, [&](const Item& item) { return bin_of(item, best_axis) < best_bin; });
    if (cut != first && cut != last) return static_cast<std::size_t>(cut - begin);
  }
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const auto cut = first + (last - first) / 2;
  std::nth_element(first, cut, last, [axis](const Item& a, const Item& b) {
    return a.middle[axis] < b.middle[axis];
  });
  return static_cast<std::size_t>(cut - begin);
}

}  // namespace lume::geometry
