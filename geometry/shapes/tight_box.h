// SPDX-License-Identifier: Apache-2.0
// The tightest box around a surface of which is only known how to prove that a box holds none of
// it. Acceleration structures are only as good as their boxes.
#pragma once

#include "geometry/bounds.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace lume::geometry {

/// Finds one box around a surface; tight_box() below is the way to use it.
template <class MayContain>
class BoxTightener {
 public:
  BoxTightener(const DBounds& box, const MayContain& may_contain)
      : box_(box), may_contain_(may_contain) {}

  /// Nothing if the box is proven to hold none of the surface.
  std::optional<DBounds> run() {
    if (!may_contain_(box_.lower, box_.upper)) return std::nullopt;
    for (int pass = 0; pass < k_passes; ++pass) {
      const DVec3 before = box_.size();
      size_ = before;
      for (int axis = 0; axis < 3; ++axis) {
        if (!pull(axis, true) || !pull(axis, false)) return std::nullopt;
      }
      const DVec3 after = box_.size();
      const bool same = after.x > 0.9 * before.x && after.y > 0.9 * before.y;
      if (same && after.z > 0.9 * before.z) break;  // as fine as another pass would find it
    }
    return box_;
  }

 private:
  // A cell is small enough at this part of the box's size. It may be wider than it is deep: where a
  // surface touches the side it runs along it.
  static constexpr double k_depth = 0.005;
  static constexpr double k_width = 0.016;
  static constexpr int k_passes = 6;
  static constexpr int k_cells_per_side = 4000;

  struct Cell {
    DBounds box;
    double distance = 0.0;  // from the side that is being pulled
    int depth = 0;
  };

  /// Pulls one side of the box inwards, best cell first: the first cell that is small enough cannot
  /// be undercut by any other. Whenever the search is stopped, the best cell's distance is sound.
  bool pull(int axis, bool lower_side) {
    cells_.clear();
    push({box_, 0.0, 0});
    for (int count = 0; !cells_.empty(); ++count) {
      const Cell cell = pop();
      const int longest = longest_axis(cell.box, axis);
      if (longest < 0 || count == k_cells_per_side) {
        double& side = lower_side ? box_.lower[axis] : box_.upper[axis];
        side = lower_side ? cell.box.lower[axis] : cell.box.upper[axis];
        return true;
      }
      split(cell, longest, axis, lower_side);
    }
    return false;  // nothing of the surface is left
  }

  void split(const Cell& cell, int longest, int axis, bool lower_side) {
    const double middle = 0.5 * cell.box.lower[longest] + 0.5 * cell.box.upper[longest];
    for (const bool first : {true, false}) {
      Cell child = cell;
      ++child.depth;
      (first ? child.box.upper : child.box.lower)[longest] = middle;
      if (!may_contain_(child.box.lower, child.box.upper)) continue;
      child.distance = lower_side ? child.box.lower[axis] - box_.lower[axis]
                                  : box_.upper[axis] - child.box.upper[axis];
      push(child);
    }
  }

  /// The axis along which a cell is too large by most, or -1.
  [[nodiscard]] int longest_axis(const DBounds& cell, int pulled) const {
    int longest = -1;
    double most = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double tolerance = (axis == pulled ? k_depth : k_width) * size_[axis];
      const double excess = (cell.upper[axis] - cell.lower[axis]) / tolerance;
      if (excess > most) {
        longest = axis;
        most = excess;
      }
    }
    return longest;
  }

  void push(const Cell& cell) {
    cells_.push_back(cell);
    std::push_heap(cells_.begin(), cells_.end(), is_worse);
  }
  Cell pop() {
    std::pop_heap(cells_.begin(), cells_.end(), is_worse);
    const Cell best = cells_.back();
    cells_.pop_back();
    return best;
  }
  /// Of cells at the same distance the deepest is tried first: it ends the search soonest.
  static bool is_worse(const Cell& a, const Cell& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.depth < b.depth;
  }

  DBounds box_;
  const MayContain& may_contain_;
  DVec3 size_{0.0};          // of the box at the start of a pass
  std::vector<Cell> cells_;  // a heap
};

/// The tightest box around the surface inside `box` (finite corners), to about half a percent of
/// its size on each side, or nothing if it is proven that there is none. `may_contain(lower,
/// upper)` returns false only if the surface certainly has no point with lower <= p <= upper; the
/// more often it does so for small boxes, the tighter the result, which is sound in any case. It is
/// called at most some 48,000 times a pass, usually less than 2,000.
template <class MayContain>
[[nodiscard]] std::optional<DBounds> tight_box(const DBounds& box, const MayContain& may_contain) {
  return BoxTightener<MayContain>(box, may_contain).run();
}

}  // namespace lume::geometry
