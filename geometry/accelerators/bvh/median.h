// SPDX-License-Identifier: Apache-2.0
// Halves: each child gets as many items as the other, on the two sides of the median along the
// longest axis (Kay and Kajiya 1986, "Ray Tracing Complex Scenes", section 3, who take the axes in
// turn). As balanced as a tree can be, and blind to where rays go.
#pragma once

#include "geometry/accelerators/bvh/top_down.h"

namespace lume::geometry::bvh {

/// Puts the lower half along the axis on which the centroids lie farthest apart first. Returns how
/// many that are.
std::size_t halve(std::span<Entry> entries);

[[nodiscard]] BinaryTree build_median(const Items& items);

}  // namespace lume::geometry::bvh
