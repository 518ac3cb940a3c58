// SPDX-License-Identifier: Apache-2.0
// The second half of a build: binary nodes become nodes of eight children, and leaves, so that the
// expected cost of a ray is least (Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", section 3.1).
#pragma once

#include "geometry/accelerators/wide/binary_tree.h"
#include "geometry/accelerators/wide/builder.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lume::geometry::wide {

/// A tree, or part of one, whose numbers count from 0.
struct Part {
  std::vector<Node> nodes;
  std::vector<TriangleBlock> blocks;
  std::vector<std::uint32_t> entries;
  std::uint32_t root = 0;
  std::size_t depth = 0;  ///< of nodes
  std::size_t leaf_count = 0;
  std::size_t reference_count = 0;
  double cost = 0.0;  ///< half areas times what StructureStats counts
};

/// A child that is a part of its own, built later.
struct OpenChild {
  Range range;
  std::uint32_t node = 0;
  std::uint32_t lane = 0;
};

struct CollapseSource {
  const TriangleItems* triangles = nullptr;  ///< null on the upper level
  BuildConfig config;
};

/// Up to four triangles.
[[nodiscard]] TriangleBlock make_block(const TriangleItems& triangles,
                                       std::span<const std::uint32_t> items);

/// `open`: leaves of the binary tree are not leaves but parts to come, to which they are added. The
/// root is then a node.
[[nodiscard]] Part collapse(const std::vector<BinaryNode>& binary, const CollapseSource& source,
                            std::vector<OpenChild>* open);

}  // namespace lume::geometry::wide
