// SPDX-License-Identifier: Apache-2.0
// A hierarchy with eight children a node (Dammertz, Hanika and Keller 2008; Wald, Benthin and
// Boulos 2008), laid out for SIMD: the boxes of all children are tested at once, and triangles in
// blocks of four. Plain data that kernels of every instruction set read, hence without glm.
#pragma once

#include "geometry/accelerators/wide/huge_array.h"

#include <cstddef>
#include <cstdint>

namespace lume::geometry::wide {

inline constexpr std::size_t k_width = 8;
inline constexpr std::uint32_t k_no_item = 0xffff'ffffu;

/// Where a child is: a node, or some consecutive leaf entries. Packed in 32 bits.
struct Child {
  static constexpr std::uint32_t k_leaf = 0x8000'0000u;
  static constexpr std::uint32_t k_most_entries = 16;
  static constexpr std::uint32_t k_most_first = 1u << 27u;  ///< leaf entries in a tree

  static constexpr std::uint32_t leaf(std::uint32_t first, std::uint32_t count) {
    return k_leaf | (count - 1) << 27u | first;
  }
  static constexpr bool is_leaf(std::uint32_t child) { return (child & k_leaf) != 0; }
  static constexpr std::uint32_t first(std::uint32_t child) { return child & (k_most_first - 1); }
  static constexpr std::uint32_t count(std::uint32_t child) {
    return (child >> 27u & (k_most_entries - 1)) + 1;
  }
};

/// The boxes of up to eight children. Those that are not there have boxes which no ray meets.
struct alignas(32) Node {
  float planes[6][k_width];  ///< lower x, upper x, lower y, upper y, lower z, upper z
  std::uint32_t child[k_width];
};

/// Four triangles. Of those that are not there the corners are not numbers, which no ray meets.
struct alignas(32) TriangleBlock {
  static constexpr std::size_t k_size = 4;
  float corner[3][3][k_size];  ///< corner, axis, triangle
  std::uint32_t item[k_size];
};

/// A leaf entry is a block of triangles (lower level) or the number of a placement (upper level).
struct Tree {
  HugeArray<Node> nodes;
  HugeArray<TriangleBlock> blocks;
  HugeArray<std::uint32_t> entries;
  /// Triangles beyond what boxes can be tested for in float; every ray asks them.
  HugeArray<TriangleBlock> outliers;
  std::uint32_t root = 0;
  std::size_t depth = 0;
  std::size_t leaf_count = 0;
  std::size_t reference_count = 0;     ///< of items in leaves
  double sah_cost = 0.0;               ///< nodes and blocks that a ray enters: see StructureStats
  alignas(16) float farthest[4] = {};  ///< largest absolute coordinate of all boxes, by axis
  bool is_empty = true;
};

/// Nodes from the root to the deepest leaf at most; a builder halves numbers before it gets there.
inline constexpr std::size_t k_max_depth = 64;
/// A node takes itself off the stack and puts on at most eight.
inline constexpr std::size_t k_stack_size = (k_width - 1) * k_max_depth + 1;

}  // namespace lume::geometry::wide
