// SPDX-License-Identifier: Apache-2.0
// Makes a good tree of any: takes out what lies badly and puts it where it costs least, again and
// again (Bittner, Hapala, Havran 2013, "Fast Insertion-Based Optimization of Bounding Volume
// Hierarchies").
#pragma once

#include "geometry/accelerators/bvh/tree.h"

namespace lume::geometry::bvh {

/// The same leaves in a tree of lower sah_cost, or the tree as it was if none is found or it would
/// be too deep.
[[nodiscard]] BinaryTree reinsert(const BinaryTree& tree);

/// The binned SAH's tree, made better.
[[nodiscard]] BinaryTree build_reinserted(const Items& items);

}  // namespace lume::geometry::bvh
