// SPDX-License-Identifier: Apache-2.0
// What structures are compared by besides time: what they are made of, and what a query looks at.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lume::geometry {

/// What one query did, or many.
struct TraversalCost {
  std::uint64_t nodes = 0;            ///< nodes, cells or other volumes that were entered
  std::uint64_t primitive_tests = 0;  ///< rays against triangles and shapes

  void add_node() { ++nodes; }
  void add_test() { ++primitive_tests; }
};

/// In the place of a TraversalCost where nobody asks: nothing is left of it in the code.
struct NoCost {
  void add_node() {}
  void add_test() {}
};

/// What a hierarchy or grid is made of.
struct StructureStats {
  std::size_t nodes = 0;   ///< inner ones, or cells
  std::size_t leaves = 0;  ///< that hold something
  std::size_t depth = 0;   ///< the most nodes on the way to a leaf
  std::size_t references =
      0;  ///< of primitives in leaves; more than primitives where one is in many
  /// Expected cost of a ray that meets the whole: 1 for each node entered, 1 for each primitive in
  /// a leaf entered, by the ratio of areas (MacDonald and Booth 1990). 0 for what is no hierarchy.
  double sah_cost = 0.0;
  std::size_t memory_bytes = 0;

  /// Of several structures side by side.
  StructureStats& operator+=(const StructureStats& other) {
    nodes += other.nodes;
    leaves += other.leaves;
    depth = depth > other.depth ? depth : other.depth;
    references += other.references;
    sah_cost += other.sah_cost;
    memory_bytes += other.memory_bytes;
    return *this;
  }
};

}  // namespace lume::geometry
