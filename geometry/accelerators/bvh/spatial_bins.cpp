// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/spatial_bins.h"

#include <algorithm>
#include <array>

namespace lume::geometry::bvh {
namespace {

constexpr int k_most_slices = 16;

/// A slice of space: what is in it, and how many items begin and end there.
struct Slice {
  Bounds box;
  std::size_t begins = 0;
  std::size_t ends = 0;
};

/// A box cut into equal slices along one axis.
class Slices {
 public:
  Slices(const Bounds& box, int axis, int count)
      : axis_(axis),
        count_(count),
        lower_(box.lower[axis]),
        width_((static_cast<double>(box.upper[axis]) - lower_) / count) {}

  /// Whether planes differ from each other, and from the sides of the box.
  [[nodiscard]] bool can_split() const {
    for (int i = 0; i < count_; ++i) {
      if (!(plane(i) < plane(i + 1))) return false;
    }
    return true;
  }
  /// The lower side of slice i.
  [[nodiscard]] float plane(int i) const { return static_cast<float>(lower_ + i * width_); }

  void count(const Entry& entry) {
    ++slices_[slice_of(entry.box.lower[axis_])].begins;
    ++slices_[slice_of(entry.box.upper[axis_])].ends;
  }

  /// Whether there is a plane that cuts no more than `spare`, so that cutting things to fit is
  /// worth its time.
  [[nodiscard]] bool can_afford_plane(std::size_t spare) const {
    std::size_t begun = 0;
    std::size_t ended = 0;
    for (int i = 0; i + 1 < count_; ++i) {
      begun += slices_[i].begins;
      ended += slices_[i].ends;
      if (begun - ended <= spare) return true;
    }
    return false;
  }

  /// Puts the parts of an entry into their slices.
  void add(const Items& items, const Entry& entry) {
    const int first = slice_of(entry.box.lower[axis_]);
    const int last = slice_of(entry.box.upper[axis_]);
    if (first == last) slices_[first].box.add(entry.box);
    for (int i = first; i <= last && first != last; ++i) {
      Bounds box = entry.box;
      box.lower[axis_] = std::max(box.lower[axis_], plane(i));
      box.upper[axis_] = std::min(box.upper[axis_], plane(i + 1));
      slices_[i].box.add(items.clipped(entry.item, box));
    }
  }

  /// Puts the cheapest plane into `best` if it is cheaper and cuts no more than `spare`.
  void try_planes(std::size_t count, std::size_t spare, SpatialSplit& best) const {
    std::array<Slice, k_most_slices> above = slices_;
    for (int i = count_ - 2; i >= 0; --i) {
      above[i].box.add(above[i + 1].box);
      above[i].ends += above[i + 1].ends;
    }
    Bounds box;
    std::size_t begun = 0;
    for (int i = 1; i < count_; ++i) {
      box.add(slices_[i - 1].box);
      begun += slices_[i - 1].begins;
      if (begun + above[i].ends > count + spare || begun == 0 || above[i].ends == 0) continue;
      const double cost = half_area(box) * static_cast<double>(begun) +
                          half_area(above[i].box) * static_cast<double>(above[i].ends);
      if (cost < best.cost) best = {cost, axis_, plane(i), box, above[i].box, begun, above[i].ends};
    }
  }

 private:
  [[nodiscard]] int slice_of(float x) const {
    const int slice = static_cast<int>((static_cast<double>(x) - lower_) / width_);
    return std::clamp(slice, 0, count_ - 1);
  }

  int axis_;
  int count_;
  double lower_;
  double width_;
  std::array<Slice, k_most_slices> slices_{};
};

/// Decides for each entry, as the sides fill.
class Cutter {
 public:
  Cutter(const Items& items, const SpatialSplit& split)
      : items_(items),
        split_(split),
        left_box_(split.left),
        right_box_(split.right),
        left_count_(static_cast<double>(split.left_count)),
        right_count_(static_cast<double>(split.right_count)) {}

  void add(const Entry& entry) {
    if (entry.box.upper[split_.axis] <= split_.plane) {
      left_.push_back(entry);
    } else if (entry.box.lower[split_.axis] >= split_.plane) {
      right_.push_back(entry);
    } else {
      add_cut(entry);
    }
  }

  [[nodiscard]] std::pair<std::vector<Entry>, std::vector<Entry>> take() {
    return {std::move(left_), std::move(right_)};
  }

 private:
  void add_cut(const Entry& entry) {
    Bounds left_box = entry.box;
    Bounds right_box = entry.box;
    left_box.upper[split_.axis] = right_box.lower[split_.axis] = split_.plane;
    const Entry left{items_.clipped(entry.item, left_box), entry.item};
    const Entry right{items_.clipped(entry.item, right_box), entry.item};
    Bounds all_left = left_box_;
    Bounds all_right = right_box_;
    all_left.add(entry.box);
    all_right.add(entry.box);
    const double left_area = half_area(left_box_);
    const double right_area = half_area(right_box_);
    const double cost = left_area * left_count_ + right_area * right_count_;
    const double cost_left = half_area(all_left) * left_count_ + right_area * (right_count_ - 1.0);
    const double cost_right = left_area * (left_count_ - 1.0) + half_area(all_right) * right_count_;
    if (right.box.is_empty() || cost_left < std::min(cost, cost_right)) {
      // All of it is there, even if its part was rounded away.
      left_.push_back(entry);
      left_box_ = all_left;
      right_count_ -= 1.0;
    } else if (left.box.is_empty() || cost_right < cost) {
      right_.push_back(entry);
      right_box_ = all_right;
      left_count_ -= 1.0;
    } else {
      left_.push_back(left);
      right_.push_back(right);
    }
  }

  const Items& items_;
  const SpatialSplit& split_;
  Bounds left_box_, right_box_;
  double left_count_, right_count_;
  std::vector<Entry> left_, right_;
};

}  // namespace

SpatialSplit find_spatial_split(const Items& items, std::span<const Entry> entries,
                                std::size_t spare) {
  Bounds box;
  for (const Entry& entry : entries) box.add(entry.box);
  const auto count = static_cast<int>(std::min<std::size_t>(k_most_slices, entries.size()));
  SpatialSplit best;
  for (int axis = 0; axis < 3 && spare > 0; ++axis) {
    Slices slices(box, axis, count);
    if (!slices.can_split()) continue;
    for (const Entry& entry : entries) slices.count(entry);
    if (!slices.can_afford_plane(spare)) continue;
    for (const Entry& entry : entries) slices.add(items, entry);
    slices.try_planes(entries.size(), spare, best);
  }
  return best;
}

std::pair<std::vector<Entry>, std::vector<Entry>> cut_entries(const Items& items,
                                                              std::span<const Entry> entries,
                                                              const SpatialSplit& split) {
  Cutter cutter(items, split);
  for (const Entry& entry : entries) cutter.add(entry);
  return cutter.take();
}

}  // namespace lume::geometry::bvh
