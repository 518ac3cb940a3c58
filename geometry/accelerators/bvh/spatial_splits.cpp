// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/spatial_splits.h"

#include "geometry/accelerators/bvh/binned_sah.h"
#include "geometry/accelerators/bvh/median.h"
#include "geometry/accelerators/bvh/spatial_bins.h"

#include <utility>

namespace lume::geometry::bvh {
namespace {

/// The items of a node, or the parts of them that are in it, and how many more its leaves may have.
struct Job {
  std::vector<Entry> entries;
  std::size_t spare = 0;
};

Bounds around(const std::vector<Entry>& entries) {
  Bounds box;
  for (const Entry& entry : entries) box.add(entry.box);
  return box;
}

double sum_of_areas(const std::vector<Entry>& entries) {
  double sum = 0.0;
  for (const Entry& entry : entries) sum += half_area(entry.box);
  return sum;
}

/// What two boxes have in common.
Bounds overlap(const Bounds& a, const Bounds& b) {
  const Bounds both{glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
  return glm::all(glm::lessThanEqual(both.lower, both.upper)) ? both : Bounds();
}

class SpatialBuilder {
 public:
  explicit SpatialBuilder(const Items& items)
      : items_(items), root_area_(half_area(items.all_bounds())) {
    if (items.size() == 0) return;
    tree_.nodes.emplace_back();
    const double most = k_most_references * items.size();
    grow(0, {list_entries(items), static_cast<std::size_t>(most) - items.size()}, 0);
  }

  [[nodiscard]] BinaryTree& tree() { return tree_; }

 private:
  void grow(std::size_t node, Job job, int depth) {
    tree_.nodes[node].volume = around(job.entries);
    Job second;
    if (!split(job, second, depth)) {
      tree_.nodes[node].first = static_cast<std::uint32_t>(tree_.references.size());
      tree_.nodes[node].count = static_cast<std::uint32_t>(job.entries.size());
      for (const Entry& entry : job.entries) tree_.references.push_back(entry.item);
      return;
    }
    const std::size_t first = tree_.nodes.size();
    tree_.nodes[node].first = static_cast<std::uint32_t>(first);
    tree_.nodes.resize(first + 2);
    grow(first, std::move(job), depth + 1);
    grow(first + 1, std::move(second), depth + 1);
  }

  /// Moves a part of the job into the second one, unless it is to be a leaf.
  bool split(Job& job, Job& second, int depth) {
    std::vector<Entry>& entries = job.entries;
    if (entries.size() < 2) return false;
    if (depth >= k_free_depth) {
      return entries.size() > k_most_in_leaf && divide(job, second, halve(entries));
    }
    const double area = half_area(around(entries));
    const CentroidBins bins(entries);
    const BinSplit by_list = find_split(entries, bins);
    if (is_worth_a_try(by_list)) {
      const SpatialSplit in_space = find_spatial_split(items_, entries, job.spare);
      const bool is_best = in_space.cost < by_list.cost;
      if (is_best && advise(entries.size(), area, in_space.cost) == Advice::split &&
          cut(job, second, in_space)) {
        return true;
      }
    }
    switch (advise(entries.size(), area, by_list.cost)) {
      case Advice::keep_together:
        return false;
      case Advice::split:
        return divide(job, second, part(entries, bins, by_list));
      case Advice::split_anyhow:
        break;
    }
    return divide(job, second, halve(entries));
  }

  /// Cutting is tried only where children overlap by a part of the scene that rays are likely to
  /// meet: the paper's alpha (section 4.5).
  [[nodiscard]] bool is_worth_a_try(const BinSplit& by_list) const {
    constexpr double k_alpha = 1e-5;
    if (by_list.cost == std::numeric_limits<double>::infinity()) return true;
    return half_area(overlap(by_list.left, by_list.right)) > k_alpha * root_area_;
  }

  /// Entries from `first_count` on become the second job's.
  static bool divide(Job& job, Job& second, std::size_t first_count) {
    const auto second_begin = job.entries.begin() + static_cast<std::ptrdiff_t>(first_count);
    second.entries.assign(second_begin, job.entries.end());
    job.entries.erase(second_begin, job.entries.end());
    share_spare(job, second);
    return true;
  }

  /// False, and nothing is done, if all would come to one side or there would be too many.
  bool cut(Job& job, Job& second, const SpatialSplit& in_space) {
    auto [left, right] = cut_entries(items_, job.entries, in_space);
    const std::size_t count = left.size() + right.size();
    const std::size_t most = job.entries.size() + job.spare;
    if (left.empty() || right.empty() || count > most) return false;
    job = {std::move(left), most - count};
    second.entries = std::move(right);
    share_spare(job, second);
    return true;
  }

  /// Large boxes have the most to gain from being cut.
  static void share_spare(Job& job, Job& second) {
    const double area = sum_of_areas(job.entries);
    const double sum = area + sum_of_areas(second.entries);
    const std::size_t spare = job.spare;
    if (sum > 0.0) job.spare = static_cast<std::size_t>(static_cast<double>(spare) * (area / sum));
    second.spare = spare - job.spare;
  }

  const Items& items_;
  double root_area_;
  BinaryTree tree_;
};

}  // namespace

BinaryTree build_spatial_splits(const Items& items) {
  return std::move(SpatialBuilder(items).tree());
}

}  // namespace lume::geometry::bvh
