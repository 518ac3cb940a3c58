// SPDX-License-Identifier: Apache-2.0
// Space cut into equal cells: how many, where they are, and which of them a box touches.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/crossing.h"

#include <algorithm>
#include <cstddef>

namespace lume::geometry::grid {

/// Of cells, along the three axes.
using Cell = glm::ivec3;

/// The cells from `first` to `last`, both included.
struct CellRange {
  Cell first{0};
  Cell last{0};

  [[nodiscard]] std::size_t count() const {
    const Cell size = last - first + 1;
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           static_cast<std::size_t>(size.z);
  }
};

/// A box around all items, cut evenly along each axis. An item is in all cells that its box touches
/// when it is made a little wider, by k_margin of a cell. So a walk from cell to cell may take a
/// plane for a little nearer or farther than it is, and still come through a cell of every item
/// that the ray meets.
class Lattice {
 public:
  static constexpr double k_margin = 0.01;

  /// About `density` cells for each item, as near to cubes as they can be.
  Lattice(const Items& items, double density);

  [[nodiscard]] const Bounds& all() const { return all_; }
  /// Of cells along an axis.
  [[nodiscard]] int count(int axis) const { return count_[axis]; }
  [[nodiscard]] std::size_t count() const { return CellRange{Cell(0), count_ - 1}.count(); }

  /// The place in memory of a cell, and of its neighbour on an axis how much farther on.
  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.x) +
           static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(stride(1)) +
           static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(stride(2));
  }
  [[nodiscard]] std::ptrdiff_t stride(int axis) const {
    std::ptrdiff_t result = 1;
    for (int i = 0; i < axis; ++i) result *= count_[i];
    return result;
  }

  /// The lower side of the i-th cell along an axis.
  [[nodiscard]] double plane(int axis, int i) const { return lower_[axis] + i * size_[axis]; }
  /// The cell around a point, or the one nearest to it.
  [[nodiscard]] Cell cell_at(const DVec3& point) const {
    Cell cell(0);
    for (int axis = 0; axis < 3; ++axis) {
      const double place = (point[axis] - lower_[axis]) * per_length_[axis];
      cell[axis] = static_cast<int>(std::clamp(place, 0.0, count_[axis] - 1.0));
    }
    return cell;
  }
  /// The cells that a box touches, or nearly touches.
  [[nodiscard]] CellRange touched_by(const Bounds& box) const {
    const DVec3 margin = k_margin * size_;
    return {cell_at(DVec3(box.lower) - margin), cell_at(DVec3(box.upper) + margin)};
  }
  /// A cell with its margin around it.
  [[nodiscard]] Bounds bounds(const Cell& cell) const;

  /// Whether what is rounded on a ray is little against the margin. Else it comes from so far away
  /// that it cannot tell cells apart.
  [[nodiscard]] bool is_fine_for(const ObjectRay& ray) const;

 private:
  Bounds all_;
  Cell count_{1};
  DVec3 lower_{0.0};
  DVec3 size_{0.0};        ///< of a cell
  DVec3 per_length_{0.0};  ///< cells along each axis; 0 where there is one
};

}  // namespace lume::geometry::grid
