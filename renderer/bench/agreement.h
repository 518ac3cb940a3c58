// SPDX-License-Identifier: Apache-2.0
// Do structures give the same answers? A race between answers of different quality means little.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "renderer/bench/ray_sets.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lume::renderer {

/// How the answers of a structure compare with those of the reference, over one ray set.
struct Agreement {
  std::size_t rays = 0;  ///< that both were asked
  /// Another primitive, but at the same t to one part in a million: surfaces in one place, and rays
  /// along the edge that two triangles share.
  std::size_t ties = 0;
  std::size_t mismatches = 0;  ///< another primitive elsewhere, or a hit where there is none
};

/// One ray's answers compared.
enum class Verdict { same, tie, mismatch };

/// Where they differ, t is computed from the primitives themselves.
[[nodiscard]] Verdict compare_hits(const geometry::World& world, const geometry::HoleTest* holes,
                                   const geometry::Ray& ray,
                                   const std::optional<geometry::Hit>& expected,
                                   const std::optional<geometry::Hit>& actual);

struct AgreementSettings {
  std::size_t rays = std::size_t{1} << 16;  ///< at most, spread over the set
  double budget_seconds = 1.0;  ///< for each structure and set; slow ones are asked less
};

/// Asks every structure about the set's rays, in the way the set is shot: which primitive is first,
/// or whether there is any.
[[nodiscard]] std::vector<Agreement> compare_structures(
    const geometry::World& world, const geometry::HoleTest* holes,
    const geometry::Accelerator& reference,
    std::span<const geometry::Accelerator* const> structures, const RaySet& set,
    const AgreementSettings& settings);

}  // namespace lume::renderer
