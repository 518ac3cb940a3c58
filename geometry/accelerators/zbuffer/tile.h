// SPDX-License-Identifier: Apache-2.0
// A square of cells, which one thread draws from beginning to end.
#pragma once

#include "geometry/accelerators/zbuffer/view.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lume::geometry::zbuffer {

/// Cells along a tile's side.
inline constexpr int k_tile = 16;

/// How tiles cover the picture.
class TileGrid {
 public:
  explicit TileGrid(const View& view)
      : cells_(view.size()), size_((view.size() + k_tile - 1) / k_tile) {}

  [[nodiscard]] std::size_t count() const { return index({0, size_.y}); }
  [[nodiscard]] std::size_t index(const glm::ivec2& tile) const {
    return static_cast<std::size_t>(tile.y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(tile.x);
  }
  /// Of a tile by its index.
  [[nodiscard]] CellRange cells(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(size_.x);
    return cells(glm::ivec2(static_cast<int>(index % columns), static_cast<int>(index / columns)));
  }
  /// Of a tile by its column and row.
  [[nodiscard]] CellRange cells(const glm::ivec2& tile) const {
    return {k_tile * tile, glm::min(k_tile * (tile + 1), cells_)};
  }

 private:
  glm::ivec2 cells_;
  glm::ivec2 size_;
};

/// An item that a ray through a cell may meet, and how near that is at most (Footprint).
struct Candidate {
  std::uint32_t item = 0;
  float nearness = 0.0f;
};

/// The candidates of each cell.
class Tile {
 public:
  Tile() = default;
  /// Of candidates in any order, each with the place of its cell.
  explicit Tile(std::vector<std::pair<std::uint32_t, Candidate>> placed);

  /// From 0 to k_tile * k_tile - 1, by column and row in the tile.
  [[nodiscard]] static std::uint32_t place(const glm::ivec2& cell) {
    return static_cast<std::uint32_t>(cell.y * k_tile + cell.x);
  }
  /// The nearest first.
  [[nodiscard]] std::span<const Candidate> candidates(const glm::ivec2& cell) const {
    const std::uint32_t i = place(cell);
    return std::span(candidates_).subspan(first_[i], first_[i + 1] - first_[i]);
  }
  [[nodiscard]] std::size_t candidate_count() const { return candidates_.size(); }

 private:
  std::array<std::uint32_t, std::size_t{k_tile} * k_tile + 1> first_{};  ///< and behind the last
  std::vector<Candidate> candidates_;
};

}  // namespace lume::geometry::zbuffer
