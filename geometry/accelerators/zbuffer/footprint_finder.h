// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/zbuffer/projector.h"
#include "geometry/accelerators/zbuffer/scene_items.h"

#include <optional>

namespace lume::geometry::zbuffer {

/// The footprints of items, best asked for in their order: what those of one placement have in
/// common is kept.
class FootprintFinder {
 public:
  FootprintFinder(const SceneItems& items, const View& view) : items_(items), view_(view) {}

  [[nodiscard]] std::optional<Footprint> find(std::uint32_t item) {
    if (!projector_ || item < range_.first || item >= range_.last) enter(items_.range_of(item));
    if (items_.is_shape(range_.placement)) {
      return projector_->box(items_.placements().bounds(range_.placement));
    }
    const Hit hit = items_.identity(range_, item);
    return projector_->triangle(items_.corners(hit), items_.has_holes(hit));
  }

 private:
  void enter(const ItemRange& range) {
    range_ = range;
    // The box of a shape is in the scene's frame.
    const bool is_shape = items_.is_shape(range.placement);
    projector_.emplace(view_, is_shape ? Transform() : items_.transform(range.placement));
  }

  const SceneItems& items_;
  const View& view_;
  ItemRange range_;
  std::optional<Projector> projector_;
};

}  // namespace lume::geometry::zbuffer
