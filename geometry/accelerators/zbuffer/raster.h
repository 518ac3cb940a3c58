// SPDX-License-Identifier: Apache-2.0
// The z-buffer (Catmull 1974, "A Subdivision Algorithm for Computer Display of Curved Surfaces"),
// with a list in each cell in the place of one depth: everything that may be nearest anywhere in
// the cell. Scenes are drawn item by item, not ray by ray: first into tiles, then, one tile after
// the other, into cells.
#pragma once

#include "geometry/accelerators/traversal_cost.h"
#include "geometry/accelerators/zbuffer/scene_items.h"
#include "geometry/accelerators/zbuffer/tile.h"
#include "geometry/accelerators/zbuffer/view.h"

#include <optional>
#include <span>
#include <vector>

namespace lume::geometry::zbuffer {

class Raster {
 public:
  /// Draws all items. None if that would take more memory than it is worth.
  [[nodiscard]] static std::optional<Raster> draw(const SceneItems& items, const View& view);

  /// What may be met first through a cell, the nearest first.
  [[nodiscard]] std::span<const Candidate> candidates(const glm::ivec2& cell) const {
    return tiles_[grid_.index(cell / k_tile)].candidates(cell % k_tile);
  }

  [[nodiscard]] StructureStats stats() const;

 private:
  explicit Raster(const View& view) : grid_(view), tiles_(grid_.count()) {}

  TileGrid grid_;
  std::vector<Tile> tiles_;
};

}  // namespace lume::geometry::zbuffer
