// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/sweep_sah.h"

#include "geometry/accelerators/bvh/binned_sah.h"
#include "geometry/accelerators/bvh/top_down.h"

#include <algorithm>
#include <array>

namespace lume::geometry::bvh {
namespace {

class Sweep {
 public:
  explicit Sweep(const Items& items) : areas_(items.size()), is_first_(items.size()) {
    for (int axis = 0; axis < 3; ++axis) {
      sorted_[axis] = list_entries(items);
      std::sort(sorted_[axis].begin(), sorted_[axis].end(), CentroidBefore{axis});
    }
    spare_.resize(items.size());
  }

  [[nodiscard]] std::vector<Entry>& list() { return sorted_[0]; }

  /// Parts a range of all three lists; see TopDown. `entries` is that of the first list.
  std::size_t split(std::span<const Entry> entries, int depth) {
    const auto begin = static_cast<std::size_t>(entries.data() - sorted_[0].data());
    const std::size_t count = entries.size();
    Cut cut;
    if (depth < k_free_depth) {
      for (int axis = 0; axis < 3; ++axis) try_cuts(axis, part(axis, begin, count), cut);
    }
    const Advice advice = advise(count, half_area(around(entries)), cut.cost);
    if (advice == Advice::keep_together) return 0;
    if (advice == Advice::split_anyhow) cut = {cut.cost, 0, count / 2};
    divide(begin, count, cut);
    return cut.first_count;
  }

 private:
  struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::size_t first_count = 0;
  };

  std::span<Entry> part(int axis, std::size_t begin, std::size_t count) {
    return std::span(sorted_[axis]).subspan(begin, count);
  }

  static Bounds around(std::span<const Entry> entries) {
    Bounds box;
    for (const Entry& entry : entries) box.add(entry.box);
    return box;
  }

  /// Once from behind, to know the areas of what is left, and once from the front.
  void try_cuts(int axis, std::span<const Entry> entries, Cut& best) {
    Bounds box;
    for (std::size_t i = entries.size() - 1; i > 0; --i) {
      box.add(entries[i].box);
      areas_[i] = half_area(box);
    }
    box = {};
    for (std::size_t i = 1; i < entries.size(); ++i) {
      box.add(entries[i - 1].box);
      const double cost = half_area(box) * static_cast<double>(i) +
                          areas_[i] * static_cast<double>(entries.size() - i);
      if (cost < best.cost) best = {cost, axis, i};
    }
  }

  /// Puts the first items along the cut's axis first in all lists, in the order they have there.
  void divide(std::size_t begin, std::size_t count, const Cut& cut) {
    const std::span<const Entry> along = part(cut.axis, begin, count);
    for (std::size_t i = 0; i < count; ++i) is_first_[along[i].item] = i < cut.first_count ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == cut.axis) continue;
      const std::span<Entry> entries = part(axis, begin, count);
      auto first = entries.begin();
      auto second = spare_.begin();
      for (const Entry& entry : entries) {
        if (is_first_[entry.item] != 0) {
          *first++ = entry;
        } else {
          *second++ = entry;
        }
      }
      std::copy(spare_.begin(), second, first);
    }
  }

  std::array<std::vector<Entry>, 3> sorted_;  ///< by axis
  std::vector<double> areas_;
  std::vector<std::uint8_t> is_first_;  ///< by item
  std::vector<Entry> spare_;
};

}  // namespace

BinaryTree build_sweep_sah(const Items& items) {
  Sweep sweep(items);
  return build_top_down(items, sweep.list(), [&sweep](std::span<const Entry> entries, int depth) {
    return sweep.split(entries, depth);
  });
}

}  // namespace lume::geometry::bvh
