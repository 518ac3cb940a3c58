// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/statistics.h"

#include <algorithm>
#include <cmath>

namespace lume::renderer {
namespace {

/// P(X <= k) of a binomial X of n and 1/2.
double cumulative_binomial(std::size_t k, std::size_t n) {
  double term = std::pow(0.5, static_cast<double>(n));
  double sum = term;
  for (std::size_t i = 1; i <= k; ++i) {
    term *= static_cast<double>(n - i + 1) / static_cast<double>(i);
    sum += term;
  }
  return sum;
}

double middle(const std::vector<double>& sorted) {
  if (sorted.empty()) return 0.0;
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return middle(values);
}

std::size_t trimmed_at_ends(std::size_t n) {
  constexpr double k_either_side = 0.025;
  std::size_t trimmed = 0;
  while (2 * (trimmed + 1) < n && cumulative_binomial(trimmed + 1, n) <= k_either_side) ++trimmed;
  return trimmed;
}

double confidence_of(std::size_t n) {
  return n == 0 ? 0.0 : 1.0 - 2.0 * cumulative_binomial(trimmed_at_ends(n), n);
}

Estimate estimate_median(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t trimmed = trimmed_at_ends(values.size());
  return {middle(values), values[trimmed], values[values.size() - 1 - trimmed]};
}

}  // namespace lume::renderer
