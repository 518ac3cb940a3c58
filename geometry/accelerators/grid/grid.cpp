// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/grid/grid.h"

#include "geometry/accelerators/registry.h"
#include "geometry/accelerators/two_level.h"

namespace lume::geometry {
namespace grid {
namespace {

/// Cells for each item. N of them for N items is the rule of Cleary and Wyvill 1988, "Analysis of
/// an Algorithm for Fast Ray Tracing Using Uniform Space Subdivision"; somewhat more, for empty
/// cells are cheaper than tests.
constexpr double k_density = 4.0;

/// So that no world, however badly it suits a grid, takes more than so many cells an item.
constexpr std::size_t k_most_touched = 64;

/// The finest lattice in which items do not touch too many cells.
Lattice choose_lattice(const Items& items) {
  double density = k_density;
  for (;;) {
    const Lattice lattice(items, density);
    std::size_t touched = 0;
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      touched += lattice.touched_by(items.bounds(i)).count();
    }
    if (lattice.count() == 1 || touched <= k_most_touched * items.size()) return lattice;
    density /= 8.0;  // half as many along each axis
  }
}

/// That an item is in a cell.
struct Membership {
  std::uint32_t cell = 0;
  std::uint32_t item = 0;
};

void add_memberships(const Items& items, std::uint32_t item, const Lattice& lattice,
                     std::vector<Membership>& result) {
  const auto [first, last] = lattice.touched_by(items.bounds(item));
  const Cell more = last - first;
  // What reaches from end to end of a row of cells touches them all.
  const bool is_row = (more.x > 0) + (more.y > 0) + (more.z > 0) <= 1;
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        const Cell cell(x, y, z);
        if (!is_row && items.clipped(item, lattice.bounds(cell)).is_empty()) continue;
        result.push_back({static_cast<std::uint32_t>(lattice.index(cell)), item});
      }
    }
  }
}

}  // namespace

Grid::Grid(const Items& items) : lattice_(choose_lattice(items)) {
  std::vector<Membership> memberships;
  memberships.reserve(std::size_t{2} * items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) add_memberships(items, i, lattice_, memberships);
  // Sorted by counting: how many are in each cell, where each cell's list ends, and then every list
  // from its end to its beginning.
  first_.resize(lattice_.count() + 1);
  for (const Membership& membership : memberships) ++first_[membership.cell];
  std::uint32_t end = 0;
  for (std::uint32_t& cell : first_) cell = end += cell;
  references_.resize(memberships.size());
  for (std::size_t i = memberships.size(); i-- > 0;) {
    references_[--first_[memberships[i].cell]] = memberships[i].item;
  }
}

StructureStats Grid::stats() const {
  StructureStats stats;
  if (references_.empty()) return stats;
  stats.nodes = lattice_.count();
  for (std::size_t i = 0; i < stats.nodes; ++i) {
    if (first_[i] != first_[i + 1]) ++stats.leaves;
  }
  stats.depth = 1;
  stats.references = references_.size();
  stats.memory_bytes = (first_.size() + references_.size()) * sizeof(std::uint32_t);
  return stats;
}

}  // namespace grid

std::unique_ptr<Accelerator> make_grid(const World& world, const HoleTest* holes,
                                       const AcceleratorOptions& options) {
  return make_two_level<grid::Grid>(world, holes, options);
}

}  // namespace lume::geometry
