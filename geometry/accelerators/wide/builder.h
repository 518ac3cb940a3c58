// SPDX-License-Identifier: Apache-2.0
// Builds wide trees: top-down by the surface area heuristic over 32 bins, with spatial splits where
// boxes would overlap, eight children at once, and subtrees in parallel.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/accelerators/wide/wide_tree.h"

namespace lume::geometry::wide {

struct BuildConfig {
  /// How many more references than items there may be, so that long items can be in several leaves.
  double extra_references = 0.3;
  /// What it costs to enter a node, in tests of a block of four triangles.
  double node_cost = 2.0;
  /// Blocks a leaf may have.
  std::uint32_t most_blocks = 4;
};

/// Over the triangles of an object. The same tree for any number of threads.
[[nodiscard]] Tree build_tree(const TriangleItems& items, const BuildConfig& config = {});

/// Over what stands in a scene; leaf entries are item numbers.
[[nodiscard]] Tree build_tree(const PlacementItems& items);

}  // namespace lume::geometry::wide
