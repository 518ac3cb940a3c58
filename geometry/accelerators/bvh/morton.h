// SPDX-License-Identifier: Apache-2.0
// The linear BVH: items in the order of their places on a curve through space, whose codes already
// are the tree (Lauterbach, Garland, Sengupta, Luebke, Manocha 2009, "Fast BVH Construction on
// GPUs"). The fastest to build: a sort.
#pragma once

#include "geometry/accelerators/bvh/tree.h"

namespace lume::geometry::bvh {

/// The lowest 21 bits of three numbers in turn: bit i of x, y and z becomes bit 3 i + 2, 3 i + 1
/// and 3 i (Morton 1966).
[[nodiscard]] std::uint64_t morton_code(std::uint32_t x, std::uint32_t y, std::uint32_t z);

[[nodiscard]] BinaryTree build_lbvh(const Items& items);

}  // namespace lume::geometry::bvh
