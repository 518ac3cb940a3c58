// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/hit.h"

#include <optional>

namespace lume::geometry {

/// What a query for the closest hit has found so far.
struct NearestHit {
  std::optional<Hit> hit = std::nullopt;
  double t = 0.0;

  /// Whether a crossing at t_new is to take the place of this one.
  [[nodiscard]] bool yields_to(const Hit& other, double t_new) const {
    return !hit || t_new < t || (t_new == t && other < *hit);
  }
};

}  // namespace lume::geometry
