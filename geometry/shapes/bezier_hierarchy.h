// SPDX-License-Identifier: Apache-2.0
// A binary hierarchy of boxes over the pieces of a Bezier surface, in one array.
#pragma once

#include "geometry/bounds.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lume::geometry {

class BezierHierarchy {
 public:
  /// The boxes of two children side by side, so that one pass tests both.
  struct Node {
    double lower[3][2];
    double upper[3][2];
    std::uint32_t child[2];  ///< a node, or a piece if the topmost bit is set
  };
  static constexpr std::uint32_t k_piece = 0x8000'0000U;
  static constexpr std::uint32_t k_none = 0xffff'ffffU;
  static constexpr int k_max_depth = 64;

  BezierHierarchy() = default;
  explicit BezierHierarchy(const std::vector<DBounds>& boxes);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// The root: a node, a piece, or nothing.
  [[nodiscard]] std::uint32_t root() const { return root_; }

 private:
  struct Item {
    DBounds box;
    DVec3 middle;
    std::uint32_t piece;
  };
  using Range = std::pair<std::size_t, std::size_t>;  ///< of items, the end excluded

  std::uint32_t build(std::vector<Item>& items, Range range, int depth);
  static std::size_t split(std::vector<Item>& items, Range range, int depth);

  std::vector<Node> nodes_;
  std::uint32_t root_ = k_none;
};

}  // namespace lume::geometry
