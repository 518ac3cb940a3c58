// SPDX-License-Identifier: Apache-2.0
#include "io/compare/flip_summary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

namespace lume::io {
namespace {

/// Sorts floats >= 0, whose bits order as they do, by eleven of these at a time: a map is sorted
/// in a fraction of the time that it takes to compute.
void sort_by_bits(std::vector<float>& values) {
  constexpr std::uint32_t k_buckets = 1u << 11;
  std::vector<float> other(values.size());
  for (const std::uint32_t shift : {0u, 11u, 22u}) {
    const auto bucket = [shift](float value) {
      return (std::bit_cast<std::uint32_t>(value) >> shift) % k_buckets;
    };
    std::array<std::size_t, k_buckets> counts{};
    for (const float value : values) ++counts[bucket(value)];
    std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), std::size_t{0});
    for (const float value : values) other[counts[bucket(value)]++] = value;
    values.swap(other);
  }
}

}  // namespace

FlipSummary summarize_flip(std::span<const float> errors) {
  FlipSummary summary;
  if (errors.empty()) return summary;
  // Sums go over sorted values, so that they depend on nothing else. Zeros add nothing to them.
  std::vector<float> sorted;
  sorted.reserve(errors.size());
  std::copy_if(errors.begin(), errors.end(), std::back_inserter(sorted),
               [](float error) { return error > 0.0f; });
  if (sorted.empty()) return summary;
  sort_by_bits(sorted);
  const double total = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  summary.mean = total / static_cast<double>(errors.size());
  summary.min = sorted.size() == errors.size() ? sorted.front() : 0.0;
  summary.max = sorted.back();

  double sum = 0.0;
  std::size_t at = 0;
  const auto quantile = [&](double share) {
    for (; at + 1 < sorted.size(); ++at) {
      const double next = sum + static_cast<double>(sorted[at]);
      if (next >= share * total) break;
      sum = next;
    }
    return static_cast<double>(sorted[at]);
  };
  summary.first_weighted_quartile = quantile(0.25);
  summary.weighted_median = quantile(0.5);
  summary.third_weighted_quartile = quantile(0.75);
  return summary;
}

}  // namespace lume::io
