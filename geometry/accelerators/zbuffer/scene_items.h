// SPDX-License-Identifier: Apache-2.0
// All that can be drawn, in one row of numbers: the triangles of every instance, and every shape
// that has an end.
#pragma once

#include "geometry/accelerators/items.h"
#include "geometry/refine.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace lume::geometry::zbuffer {

/// The items from `first` up to `last`, all of one placement.
struct ItemRange {
  std::uint32_t placement = 0;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

class SceneItems {
 public:
  explicit SceneItems(const World& world);

  /// False if there are more than there are numbers, or triangles beyond all reason.
  [[nodiscard]] bool can_draw() const { return can_draw_; }
  [[nodiscard]] const PlacementItems& placements() const { return *placements_; }
  [[nodiscard]] ItemRange range(std::uint32_t placement) const {
    return {placement, first_[placement], first_[placement + 1]};
  }
  /// Of the placement that the item is in.
  [[nodiscard]] ItemRange range_of(std::uint32_t item) const;

  [[nodiscard]] const Transform& transform(std::uint32_t placement) const {
    return world_.instances[placements_->placement(placement).instance].transform;
  }
  [[nodiscard]] bool is_shape(std::uint32_t placement) const {
    return placements_->placement(placement).shape.has_value();
  }
  /// Of a triangle, which is the item of a range.
  [[nodiscard]] Hit identity(const ItemRange& range, std::uint32_t item) const {
    const std::uint32_t instance = placements_->placement(range.placement).instance;
    Hit hit = triangles_[world_.instances[instance].object].identity(item - range.first);
    hit.instance = instance;
    return hit;
  }
  [[nodiscard]] std::array<Vec3, 3> corners(const Hit& hit) const {
    return world_.geometry(hit).mesh()->corners(hit.primitive);
  }
  [[nodiscard]] bool has_holes(const Hit& hit) const { return world_.geometry(hit).has_holes; }

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  const World& world_;
  std::deque<TriangleItems> triangles_;  ///< by object
  std::optional<PlacementItems> placements_;
  std::vector<std::uint32_t> first_;  ///< item of each placement, and behind the last
  bool can_draw_ = true;
};

}  // namespace lume::geometry::zbuffer
