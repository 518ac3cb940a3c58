// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/kd_tree/kd_tree.h"

#include "geometry/accelerators/bvh/tree.h"
#include "geometry/accelerators/kd_tree/split.h"
#include "geometry/accelerators/registry.h"
#include "geometry/accelerators/two_level.h"

#include <cmath>
#include <utility>

namespace lume::geometry {
namespace kd_tree {

/// Grows a tree from the root down.
class Builder {
 public:
  Builder(const Items& items, KdTree& tree) : divider_(items), tree_(tree) {
    // The rule of Havran 2000, "Heuristic Ray Shooting Algorithms": deeper trees are of no use,
    // whatever the heuristic says.
    const double depth = 8.0 + 1.3 * std::log2(items.size());
    max_depth_ = std::min(static_cast<std::size_t>(depth), std::size_t{k_max_depth});
  }

  void grow(std::uint32_t node, EventLists events, const Bounds& box, std::size_t spare,
            std::size_t depth) {
    const double area = bvh::half_area(box);
    const auto count = static_cast<double>(events.count);
    Split split;
    if (events.count > 0 && depth < max_depth_ && area > 0.0) {
      split = find_split(events, box, spare);
    }
    // Of all that lies in one plane or line no ray is expected to meet anything, but some do.
    const double chance = area > 0.0 ? area / root_area() : 1.0;
    if (split.cost >= k_test_cost * count) {
      tree_.sah_cost_ += chance * count;
      make_leaf(node, events);
      return;
    }
    tree_.sah_cost_ += chance;
    tree_.depth_ = std::max(tree_.depth_, depth + 1);
    const auto first = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_[node] = {split.plane.place, first, static_cast<std::uint32_t>(split.plane.axis)};
    tree_.nodes_.resize(first + 2);
    // What may still be cut is shared out by the number of items.
    const double left_part =
        static_cast<double>(split.left) / static_cast<double>(split.left + split.right);
    const std::size_t rest = spare - (split.left + split.right - events.count);
    const auto left_spare = static_cast<std::size_t>(left_part * static_cast<double>(rest));
    const auto [left_box, right_box] = cut(box, split.plane);
    auto [left, right] = divider_.divide(std::move(events), box, split.plane);
    grow(first, std::move(left), left_box, left_spare, depth + 1);
    grow(first + 1, std::move(right), right_box, rest - left_spare, depth + 1);
  }

 private:
  [[nodiscard]] double root_area() const { return bvh::half_area(tree_.all_); }

  void make_leaf(std::uint32_t node, const EventLists& events) {
    const std::vector<std::uint32_t> items = events.items();
    tree_.nodes_[node] = {0.0f, static_cast<std::uint32_t>(tree_.references_.size()),
                          3 + static_cast<std::uint32_t>(items.size())};
    tree_.references_.insert(tree_.references_.end(), items.begin(), items.end());
  }

  Divider divider_;
  KdTree& tree_;
  std::size_t max_depth_ = 0;
};

KdTree::KdTree(const Items& items) : all_(items.all_bounds()) {
  if (items.size() == 0) return;
  EventLists events;
  for (std::vector<Event>& list : events.of_axis) list.reserve(2 * std::size_t{items.size()});
  for (std::uint32_t i = 0; i < items.size(); ++i) events.add(i, items.bounds(i));
  events.sort();
  // So that no world, however badly it suits planes, takes more than so many references an item.
  constexpr std::size_t k_spare = 8;
  nodes_.emplace_back();
  Builder(items, *this).grow(0, std::move(events), all_, k_spare * items.size(), 0);
  nodes_.shrink_to_fit();
  references_.shrink_to_fit();
}

StructureStats KdTree::stats() const {
  StructureStats stats;
  for (const Node& node : nodes_) {
    if (!node.is_leaf()) ++stats.nodes;
    if (node.is_leaf() && node.count() > 0) ++stats.leaves;
  }
  stats.depth = depth_;
  stats.references = references_.size();
  stats.sah_cost = sah_cost_;
  stats.memory_bytes = nodes_.size() * sizeof(Node) + references_.size() * sizeof(std::uint32_t);
  return stats;
}

}  // namespace kd_tree

std::unique_ptr<Accelerator> make_kd_tree(const World& world, const HoleTest* holes,
                                          const AcceleratorOptions& options) {
  return make_two_level<kd_tree::KdTree>(world, holes, options);
}

}  // namespace lume::geometry
