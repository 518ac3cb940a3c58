// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/tile_lists.h"

#include "geometry/accelerators/zbuffer/footprint_finder.h"
#include "geometry/parallel.h"

#include <algorithm>

namespace lume::geometry::zbuffer {
namespace {

struct Entry {
  std::uint32_t tile = 0;
  std::uint32_t item = 0;
};

/// What is to be seen of the scene, in pieces for threads to share.
std::vector<ItemRange> visible_pieces(const SceneItems& items, const View& view) {
  constexpr std::uint32_t k_piece = 4096;
  const Projector projector(view, Transform());
  std::vector<ItemRange> pieces;
  for (std::uint32_t i = 0; i < items.placements().size(); ++i) {
    const auto footprint = projector.box(items.placements().bounds(i));
    if (!footprint) continue;
    const CellRange seen = view.touched_by(footprint->bounds);
    if (seen.first.x >= seen.last.x || seen.first.y >= seen.last.y) continue;
    const ItemRange range = items.range(i);
    for (std::uint32_t first = range.first; first < range.last;) {
      const std::uint32_t count = std::min(k_piece, range.last - first);
      pieces.push_back({i, first, first + count});
      first += count;
    }
  }
  return pieces;
}

void list_tiles(std::uint32_t item, const Footprint& footprint, const View& view,
                const TileGrid& grid, std::vector<Entry>& result) {
  const CellRange cells = view.touched_by(footprint.bounds);
  if (cells.first.x >= cells.last.x || cells.first.y >= cells.last.y) return;
  const glm::ivec2 first = cells.first / k_tile;
  const glm::ivec2 last = (cells.last - 1) / k_tile;
  for (int row = first.y; row <= last.y; ++row) {
    for (int column = first.x; column <= last.x; ++column) {
      const glm::ivec2 tile(column, row);
      if (first != last && !footprint.touches(view.rect(grid.cells(tile)))) continue;
      result.push_back({static_cast<std::uint32_t>(grid.index(tile)), item});
    }
  }
}

}  // namespace

std::optional<TileLists> TileLists::sort(const SceneItems& items, const View& view,
                                         std::size_t most) {
  const TileGrid grid(view);
  const std::vector<ItemRange> pieces = visible_pieces(items, view);
  std::vector<std::vector<Entry>> entries(pieces.size());
  Allowance allowance(most);
  parallel_for(pieces.size(), [&](std::size_t piece) {
    FootprintFinder finder(items, view);
    std::vector<Entry>& list = entries[piece];
    std::size_t taken = 0;
    for (std::uint32_t item = pieces[piece].first; item < pieces[piece].last; ++item) {
      if (allowance.is_overdrawn()) return;
      const auto footprint = finder.find(item);
      if (footprint) list_tiles(item, *footprint, view, grid, list);
      allowance.take(list.size() - taken);
      taken = list.size();
    }
  });
  if (allowance.is_overdrawn()) return std::nullopt;
  // Sorted by counting; pieces come in the order of their items.
  TileLists result;
  result.first_.resize(grid.count() + 1);
  for (const std::vector<Entry>& list : entries) {
    for (const Entry& entry : list) ++result.first_[entry.tile + 1];
  }
  for (std::size_t i = 1; i < result.first_.size(); ++i) result.first_[i] += result.first_[i - 1];
  result.items_.resize(result.first_.back());
  std::vector<std::size_t> next = result.first_;
  for (std::vector<Entry>& list : entries) {
    for (const Entry& entry : list) result.items_[next[entry.tile]++] = entry.item;
    list = {};
  }
  return result;
}

}  // namespace lume::geometry::zbuffer
