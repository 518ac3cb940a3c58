// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"
#include "shading/distribution.h"

#include <span>
#include <string_view>

namespace lume::renderer {

using geometry::Vec2;

/// A reconstruction filter, sampled in proportion to itself (Ernst, Stamminger, Greiner 2006,
/// "Filter Importance Sampling"): each sample lands in one pixel with weight 1, so pixels never
/// share data.
class PixelFilter {
 public:
  enum class Kind { box, triangle, gaussian, blackman_harris };

  /// `radius` in pixels; 0: the kind's usual one (0.5, 1, 1.5, 1.5).
  explicit PixelFilter(Kind kind = Kind::blackman_harris, float radius = 0.0f);

  /// Where around the pixel's centre the sample lies (pixels), for two uniform numbers.
  [[nodiscard]] Vec2 sample(Vec2 random) const {
    if (kind_ == Kind::box) return radius_ * (2.0f * random - 1.0f);  // as the table has it
    return {radius_ * (2.0f * distribution_.sample(random.x).position - 1.0f),
            radius_ * (2.0f * distribution_.sample(random.y).position - 1.0f)};
  }
  /// The filter's value at a distance from the centre along one axis (pixels), not normalized.
  [[nodiscard]] float evaluate(float x) const;
  [[nodiscard]] float radius() const { return radius_; }

  /// box, triangle, gaussian, blackman-harris: the order of Kind.
  [[nodiscard]] static std::span<const std::string_view> names();

 private:
  Kind kind_;
  float radius_;
  shading::Distribution1D distribution_;  ///< of the filter along one axis
};

}  // namespace lume::renderer
