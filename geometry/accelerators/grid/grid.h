// SPDX-License-Identifier: Apache-2.0
// The uniform grid (Fujimoto, Tanaka, Iwata 1986, "ARTS: Accelerated Ray-Tracing System"): space in
// equal cells, each with a list of what is in it, and a ray that looks into one cell after the
// other on its way. Quick to build and hard to beat where everything is of one size, and blind to a
// teapot in a stadium.
#pragma once

#include "geometry/accelerators/grid/lattice_walk.h"
#include "geometry/accelerators/mailbox.h"
#include "geometry/accelerators/traversal_cost.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lume::geometry::grid {

/// A Structure for TwoLevel (two_level.h).
class Grid {
 public:
  explicit Grid(const Items& items);

  template <class Visit, class Cost>
  bool traverse(const ObjectRay& ray, const Visit& visit, Cost& cost) const {
    if (references_.empty()) return false;
    const SlabRay slabs(ray, lattice_.all());
    const Interval1D inside = slabs.clip(lattice_.all(), ray.t_min, ray.t_max);
    if (inside.is_empty()) return false;
    Mailbox mailbox;
    const auto visit_range = [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t item = references_[i];
        if (mailbox.is_new(item) && visit(item)) return true;
      }
      return false;
    };
    if (!lattice_.is_fine_for(ray)) return visit_range(0, references_.size());
    LatticeWalk walk(lattice_, ray, slabs, inside.enter);
    do {
      cost.add_node();
      if (visit_range(first_[walk.index()], first_[walk.index() + 1])) return true;
      // An item may be met far behind this cell, so the walk goes on up to there. A cell that
      // begins just there may hold a lower identity.
    } while (walk.advance(std::min(inside.leave, ray.t_max)));
    return false;
  }

  [[nodiscard]] StructureStats stats() const;

 private:
  Lattice lattice_;
  std::vector<std::uint32_t> first_;  ///< reference of each cell, and behind the last
  std::vector<std::uint32_t> references_;
};

}  // namespace lume::geometry::grid
