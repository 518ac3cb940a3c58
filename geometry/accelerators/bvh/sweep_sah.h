// SPDX-License-Identifier: Apache-2.0
// The surface area heuristic over all planes: between any two items in the order of their centroids
// (MacDonald and Booth 1990, "Heuristics for Ray Tracing Using Space Subdivision"; Wald, Boulos,
// Shirley 2007, "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume Hierarchies", for
// boxes). The items are sorted once along each axis, and sorted lists stay sorted when they are
// parted, so that n items take n log n steps (as Wald and Havran 2006 do it for kd-trees).
#pragma once

#include "geometry/accelerators/bvh/tree.h"

namespace lume::geometry::bvh {

[[nodiscard]] BinaryTree build_sweep_sah(const Items& items);

}  // namespace lume::geometry::bvh
