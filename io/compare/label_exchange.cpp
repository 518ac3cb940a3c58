// SPDX-License-Identifier: Apache-2.0
#include "io/compare/label_exchange.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace lume::io {
namespace {

/// Of two assignments that differ by a swap of the stacks, the one where image 0 is actual.
Labels without_swap(const Labels& labels, std::size_t images) {
  if (labels.size() * 2 != images || labels.front() == 0) return labels;
  Labels others;
  others.reserve(labels.size());
  for (std::uint32_t i = 0; i < images; ++i) {
    if (!std::binary_search(labels.begin(), labels.end(), i)) others.push_back(i);
  }
  return others;
}

}  // namespace

Labels true_labels(std::size_t actual) {
  Labels labels(actual);
  std::iota(labels.begin(), labels.end(), 0u);
  return labels;
}

std::size_t count_labellings(std::size_t actual, std::size_t expected, std::size_t limit) {
  const bool swappable = actual == expected;
  const std::size_t most = swappable ? 2 * limit : limit;
  // The binomial coefficient, factor by factor: each product is one itself.
  std::size_t count = 1;
  for (std::size_t i = 1; i <= std::min(actual, expected) && count < most; ++i) {
    count = count * (std::max(actual, expected) + i) / i;
  }
  return std::min(swappable ? count / 2 : count, limit);
}

std::vector<Labels> draw_labellings(std::size_t actual, std::size_t expected, std::size_t count) {
  const std::size_t images = actual + expected;
  std::set<Labels> seen = {true_labels(actual)};
  std::vector<Labels> drawn;
  drawn.reserve(count);
  // From the engine's bits, because the standard leaves distributions to the library.
  std::mt19937_64 engine(1);
  std::vector<std::uint32_t> order(images);
  while (drawn.size() < count) {
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = 0; i < actual; ++i) {
      std::swap(order[i], order[i + static_cast<std::size_t>(engine() % (images - i))]);
    }
    Labels labels(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(actual));
    std::sort(labels.begin(), labels.end());
    labels = without_swap(labels, images);
    if (seen.insert(labels).second) drawn.push_back(std::move(labels));
  }
  return drawn;
}

}  // namespace lume::io
