// SPDX-License-Identifier: Apache-2.0
// The triangles of one space under a wide tree: an object's own, or those of all instances that
// stand unmoved in the scene.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/accelerators/wide/wide_tree.h"

#include <cstdint>
#include <vector>

namespace lume::geometry::wide {

class TriangleTree {
 public:
  /// `has_holes`: some of them may be holes in places.
  TriangleTree(const TriangleItems& items, bool has_holes);

  [[nodiscard]] const Tree& tree() const { return tree_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] bool has_holes() const { return has_holes_; }

  /// As the items had it.
  [[nodiscard]] Hit identity(std::uint32_t item) const;
  /// The first item above `hit`, which is none of them.
  [[nodiscard]] std::uint32_t first_above(const Hit& hit) const;

 private:
  /// Items that are consecutive primitives of a geometry: nearly always all of it.
  struct Run {
    std::uint32_t first = 0;
    Hit id;
  };

  Tree tree_;
  Bounds bounds_;
  std::vector<Run> runs_;
  bool has_holes_;
};

}  // namespace lume::geometry::wide
