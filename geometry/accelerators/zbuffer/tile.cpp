// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/tile.h"

#include <algorithm>

namespace lume::geometry::zbuffer {

Tile::Tile(std::vector<std::pair<std::uint32_t, Candidate>> placed) {
  std::sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    if (a.second.nearness != b.second.nearness) return a.second.nearness > b.second.nearness;
    return a.second.item < b.second.item;
  });
  candidates_.reserve(placed.size());
  for (const auto& [cell, candidate] : placed) {
    candidates_.push_back(candidate);
    ++first_[cell + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

}  // namespace lume::geometry::zbuffer
