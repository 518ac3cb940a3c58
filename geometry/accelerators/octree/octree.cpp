// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/octree/octree.h"

#include "geometry/accelerators/bvh/tree.h"
#include "geometry/accelerators/registry.h"
#include "geometry/accelerators/two_level.h"

#include <array>
#include <cmath>
#include <numeric>

namespace lume::geometry {
namespace octree {
namespace {

/// A box that holds no more is not cut.
constexpr std::size_t k_most_in_leaf = 8;
/// So that no world, however badly it suits an octree, takes more than so many references an item
/// beside the first.
constexpr std::size_t k_spare = 8;

/// The part of a box in one of its children.
Bounds child_box(const Bounds& box, const Vec3& middle, std::uint32_t child) {
  Bounds result = box;
  for (int axis = 0; axis < 3; ++axis) {
    (is_above(child, axis) ? result.lower : result.upper)[axis] = middle[axis];
  }
  return result;
}

/// Whether a child is above a plane that has nothing above it.
bool is_behind(const Bounds& box, const Vec3& middle, std::uint32_t child) {
  for (int axis = 0; axis < 3; ++axis) {
    if (is_above(child, axis) && middle[axis] == box.upper[axis]) return true;
  }
  return false;
}

/// Where to cut a box; at its upper side along an axis on which it has no float inside.
Vec3 middle_of(const Bounds& box) {
  Vec3 middle = box.center();
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_inside = middle[axis] > box.lower[axis] && middle[axis] < box.upper[axis];
    if (!is_inside) middle[axis] = box.upper[axis];
  }
  return middle;
}

}  // namespace

/// Grows a tree from the root down.
class Builder {
 public:
  using Numbers = std::vector<std::uint32_t>;

  Builder(const Items& items, Octree& tree) : items_(items), tree_(tree) {}

  void grow(std::uint32_t node, Numbers numbers, const Bounds& box, std::size_t spare,
            std::size_t depth) {
    const double root_area = bvh::half_area(tree_.all_);
    // All in one line: every ray that meets the root meets all of it.
    const double chance = root_area > 0.0 ? bvh::half_area(box) / root_area : 1.0;
    const Vec3 middle = middle_of(box);
    std::array<Numbers, 8> parts;
    std::size_t total = 0;
    const bool is_too_much = numbers.size() > k_most_in_leaf && depth < k_max_depth;
    if (is_too_much && middle != box.upper) total = divide(numbers, box, middle, parts);
    if (total == 0 || total > numbers.size() + spare) {
      tree_.sah_cost_ += chance * static_cast<double>(numbers.size());
      make_leaf(node, numbers);
      return;
    }
    tree_.sah_cost_ += chance;
    tree_.depth_ = std::max(tree_.depth_, depth + 1);
    // What may still be in several children is shared out by the number of items.
    const double spare_each =
        static_cast<double>(numbers.size() + spare - total) / static_cast<double>(total);
    numbers = {};  // before more memory is asked for
    const auto first = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_[node] = {middle, first, 0, false};
    tree_.nodes_.resize(first + 8);
    for (std::uint32_t child = 0; child < 8; ++child) {
      const double part_spare = spare_each * static_cast<double>(parts[child].size());
      grow(first + child, std::move(parts[child]), child_box(box, middle, child),
           static_cast<std::size_t>(part_spare), depth + 1);
    }
  }

 private:
  /// Puts each item into the children that it touches. Returns how many that are in all.
  std::size_t divide(const Numbers& numbers, const Bounds& box, const Vec3& middle,
                     std::array<Numbers, 8>& parts) const {
    std::size_t total = 0;
    for (std::uint32_t child = 0; child < 8; ++child) {
      if (is_behind(box, middle, child)) continue;
      const Bounds part = child_box(box, middle, child);
      for (const std::uint32_t i : numbers) {
        if (!items_.clipped(i, part).is_empty()) parts[child].push_back(i);
      }
      total += parts[child].size();
    }
    return total;
  }

  void make_leaf(std::uint32_t node, const Numbers& numbers) {
    const auto first = static_cast<std::uint32_t>(tree_.references_.size());
    tree_.nodes_[node] = {Vec3(0.0f), first, static_cast<std::uint32_t>(numbers.size()), true};
    tree_.references_.insert(tree_.references_.end(), numbers.begin(), numbers.end());
  }

  const Items& items_;
  Octree& tree_;
};

Octree::Octree(const Items& items) : all_(items.all_bounds()) {
  if (items.size() == 0) return;
  Builder::Numbers numbers(items.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  nodes_.emplace_back();
  Builder(items, *this).grow(0, std::move(numbers), all_, k_spare * items.size(), 0);
  nodes_.shrink_to_fit();
  references_.shrink_to_fit();
}

StructureStats Octree::stats() const {
  StructureStats stats;
  for (const Node& node : nodes_) {
    if (!node.is_leaf) ++stats.nodes;
    if (node.is_leaf && node.count > 0) ++stats.leaves;
  }
  stats.depth = depth_;
  stats.references = references_.size();
  stats.sah_cost = sah_cost_;
  stats.memory_bytes = nodes_.size() * sizeof(Node) + references_.size() * sizeof(std::uint32_t);
  return stats;
}

}  // namespace octree

std::unique_ptr<Accelerator> make_octree(const World& world, const HoleTest* holes,
                                         const AcceleratorOptions& options) {
  return make_two_level<octree::Octree>(world, holes, options);
}

}  // namespace lume::geometry
