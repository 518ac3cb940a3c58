// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/grid/lattice.h"
#include "geometry/accelerators/slab.h"

#include <limits>

namespace lume::geometry::grid {

/// From cell to cell along a ray (Amanatides and Woo 1987, "A Fast Voxel Traversal Algorithm for
/// Ray Tracing"): each step crosses the nearest of three planes, the next one along each axis. When
/// a plane is crossed follows from its number and not from when the last one was, so that errors do
/// not add up.
class LatticeWalk {
 public:
  /// Begins in the cell where the ray is at t = `start`.
  LatticeWalk(const Lattice& lattice, const ObjectRay& ray, const SlabRay& slabs, double start)
      : lattice_(lattice), slabs_(slabs), cell_(lattice.cell_at(ray.at(start))) {
    index_ = lattice.index(cell_);
    for (int axis = 0; axis < 3; ++axis) {
      step_[axis] = slabs.backwards(axis) ? -1 : 1;
      stride_[axis] = step_[axis] * lattice.stride(axis);
      find_next(axis);
    }
  }

  /// Of the cell, in memory.
  [[nodiscard]] std::size_t index() const { return index_; }
  [[nodiscard]] const Cell& cell() const { return cell_; }

  /// Goes on to the next cell, unless it begins after t = `end` or outside.
  [[nodiscard]] bool advance(double end) {
    int axis = next_[0] < next_[1] ? 0 : 1;
    if (next_[2] < next_[axis]) axis = 2;
    if (next_[axis] > end) return false;
    cell_[axis] += step_[axis];
    if (cell_[axis] < 0 || cell_[axis] >= lattice_.count(axis)) return false;
    index_ += static_cast<std::size_t>(stride_[axis]);
    find_next(axis);
    return true;
  }

 private:
  /// When the ray leaves the cell along an axis. Where there is one cell, the walk's end decides.
  void find_next(int axis) {
    const int plane = cell_[axis] + (step_[axis] > 0 ? 1 : 0);
    next_[axis] = lattice_.count(axis) == 1 ? std::numeric_limits<double>::infinity()
                                            : slabs_.earliest(axis, lattice_.plane(axis, plane));
  }

  const Lattice& lattice_;
  const SlabRay& slabs_;
  Cell cell_;
  std::size_t index_ = 0;
  int step_[3] = {};
  std::ptrdiff_t stride_[3] = {};  ///< of the step, in memory
  double next_[3] = {};            ///< t of the next plane along each axis
};

}  // namespace lume::geometry::grid
