// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/raster.h"

#include "geometry/accelerators/zbuffer/tile_lists.h"
#include "geometry/accelerators/zbuffer/tile_painter.h"
#include "geometry/parallel.h"

namespace lume::geometry::zbuffer {

std::optional<Raster> Raster::draw(const SceneItems& items, const View& view) {
  constexpr std::size_t k_most = std::size_t{1} << 26U;  // of eight bytes each: half a gigabyte
  if (!items.can_draw()) return std::nullopt;
  const auto lists = TileLists::sort(items, view, k_most);
  if (!lists) return std::nullopt;
  Raster result(view);
  Allowance allowance(k_most);
  parallel_for(result.tiles_.size(), [&](std::size_t i) {
    if (allowance.is_overdrawn()) return;
    result.tiles_[i] = paint_tile(items, view, result.grid_.cells(i), lists->items(i));
    allowance.take(result.tiles_[i].candidate_count());
  });
  if (allowance.is_overdrawn()) return std::nullopt;
  return result;
}

StructureStats Raster::stats() const {
  StructureStats stats;
  stats.depth = 1;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const CellRange cells = grid_.cells(i);
    for (int y = cells.first.y; y < cells.last.y; ++y) {
      for (int x = cells.first.x; x < cells.last.x; ++x) {
        ++stats.nodes;
        if (!candidates({x, y}).empty()) ++stats.leaves;
      }
    }
    stats.references += tiles_[i].candidate_count();
  }
  stats.memory_bytes = tiles_.size() * sizeof(Tile) + stats.references * sizeof(Candidate);
  return stats;
}

}  // namespace lume::geometry::zbuffer
