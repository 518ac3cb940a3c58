// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/zbuffer/scene_items.h"
#include "geometry/accelerators/zbuffer/tile.h"

#include <span>

namespace lume::geometry::zbuffer {

/// Draws the cells of a tile. `touching` are the items there, in ascending order.
///
/// Twice: at first each cell gets its depth, that of the farthest point of the nearest triangle
/// that covers the cell from edge to edge, so that every ray meets it. Then everything that is not
/// behind that depth all over the cell goes into the cell's list. At silhouettes and for what is
/// smaller than a cell that is several items, elsewhere nearly always one.
[[nodiscard]] Tile paint_tile(const SceneItems& items, const View& view, const CellRange& cells,
                              std::span<const std::uint32_t> touching);

}  // namespace lume::geometry::zbuffer
