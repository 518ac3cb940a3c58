// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/zbuffer/tile_painter.h"

#include "geometry/accelerators/zbuffer/footprint_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::geometry::zbuffer {
namespace {

struct Drawn {
  std::uint32_t item = 0;
  CellRange cells;  ///< of the tile, and around the footprint
  Footprint footprint;
};

std::vector<Drawn> project(const SceneItems& items, const View& view, const CellRange& cells,
                           std::span<const std::uint32_t> touching) {
  FootprintFinder finder(items, view);
  std::vector<Drawn> result;
  result.reserve(touching.size());
  for (const std::uint32_t item : touching) {
    const auto footprint = finder.find(item);
    if (!footprint) continue;
    const CellRange all = view.touched_by(footprint->bounds);
    result.push_back(
        {item, {glm::max(all.first, cells.first), glm::min(all.last, cells.last)}, *footprint});
  }
  return result;
}

/// Calls body(place in the tile, rectangle) for each cell.
template <class Body>
void for_each_cell(const CellRange& cells, const View& view, const Body& body) {
  for (int y = cells.first.y; y < cells.last.y; ++y) {
    for (int x = cells.first.x; x < cells.last.x; ++x) {
      const glm::ivec2 cell(x, y);
      body(Tile::place(cell % k_tile), view.rect({cell, cell + 1}));
    }
  }
}

float float_above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

}  // namespace

Tile paint_tile(const SceneItems& items, const View& view, const CellRange& cells,
                std::span<const std::uint32_t> touching) {
  const std::vector<Drawn> all = project(items, view, cells, touching);
  std::array<double, std::size_t{k_tile} * k_tile>
      covered{};  // nearness of what hides all behind it
  covered.fill(-std::numeric_limits<double>::infinity());
  for (const Drawn& drawn : all) {
    if (!drawn.footprint.is_solid) continue;
    for_each_cell(drawn.cells, view, [&](std::uint32_t cell, const Rect& rect) {
      if (!drawn.footprint.covers(rect)) return;
      covered[cell] = std::max(covered[cell], drawn.footprint.farthest(rect));
    });
  }
  std::vector<std::pair<std::uint32_t, Candidate>> candidates;
  for (const Drawn& drawn : all) {
    for_each_cell(drawn.cells, view, [&](std::uint32_t cell, const Rect& rect) {
      if (!drawn.footprint.touches(rect)) return;
      const double nearness = drawn.footprint.nearest(rect);
      if (nearness < covered[cell]) return;
      candidates.emplace_back(cell, Candidate{drawn.item, float_above(nearness)});
    });
  }
  return Tile(std::move(candidates));
}

}  // namespace lume::geometry::zbuffer
