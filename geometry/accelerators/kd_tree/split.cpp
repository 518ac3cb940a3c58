// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/kd_tree/split.h"

#include "geometry/accelerators/bvh/tree.h"

namespace lume::geometry::kd_tree {
namespace {

using bvh::half_area;

/// Items by where they are of a plane; one that is cut is on both sides.
struct Counts {
  std::size_t left = 0;
  std::size_t in_plane = 0;
  std::size_t right = 0;
};

class Chooser {
 public:
  Chooser(const EventLists& events, const Bounds& box, std::size_t spare)
      : box_(box), per_area_(1.0 / half_area(box)), most_(events.count + spare) {}

  void try_plane(int axis, float place, const Counts& counts) {
    if (!(place > box_.lower[axis] && place < box_.upper[axis])) return;
    if (counts.left + counts.in_plane + counts.right > most_) return;
    const auto [left, right] = cut(box_, {axis, place});
    const double left_chance = half_area(left) * per_area_;
    const double right_chance = half_area(right) * per_area_;
    for (const bool planar_left : {true, false}) {
      const std::size_t left_count = counts.left + (planar_left ? counts.in_plane : 0);
      const std::size_t right_count = counts.right + (planar_left ? 0 : counts.in_plane);
      const double tests = left_chance * static_cast<double>(left_count) +
                           right_chance * static_cast<double>(right_count);
      const bool has_empty = left_count == 0 || right_count == 0;
      const double cost = (has_empty ? k_empty_bonus : 1.0) * (1.0 + k_test_cost * tests);
      if (cost < best_.cost) best_ = {cost, {axis, place, planar_left}, left_count, right_count};
    }
  }

  [[nodiscard]] const Split& best() const { return best_; }

 private:
  const Bounds& box_;
  double per_area_;
  std::size_t most_;
  Split best_;
};

}  // namespace

Split find_split(const EventLists& events, const Bounds& box, std::size_t spare) {
  Chooser chooser(events, box, spare);
  for (int axis = 0; axis < 3; ++axis) {
    Counts counts{0, 0, events.count};
    const std::vector<Event>& list = events.of_axis[axis];
    for (std::size_t i = 0; i < list.size();) {
      const float place = list[i].place;
      std::size_t here[3] = {};  // by kind
      for (; i < list.size() && list[i].place == place; ++i) {
        ++here[static_cast<std::size_t>(list[i].kind)];
      }
      const auto [ends, planars, starts] = here;
      counts.in_plane = planars;
      counts.right -= planars + ends;
      chooser.try_plane(axis, place, counts);
      counts.left += planars + starts;
    }
  }
  return chooser.best();
}

}  // namespace lume::geometry::kd_tree
