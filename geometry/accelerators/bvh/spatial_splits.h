// SPDX-License-Identifier: Apache-2.0
// Splits space where splitting the list would leave children that overlap: an item on both sides of
// the plane is cut, and referred to from both (Stich, Friedrich, Dietrich 2009, "Spatial Splits in
// Bounding Volume Hierarchies"). Tight where long triangles lie across each other.
#pragma once

#include "geometry/accelerators/bvh/tree.h"

namespace lume::geometry::bvh {

/// There are at most this many references for each item. What is spared in one part of the tree is
/// of no use in another, so that no part depends on the order in which they are built.
inline constexpr double k_most_references = 1.3;

[[nodiscard]] BinaryTree build_spatial_splits(const Items& items);

}  // namespace lume::geometry::bvh
