// SPDX-License-Identifier: Apache-2.0
// Stateless sampling: every random number is a function of (seed, pixel, sample, dimension) alone,
// so an image depends neither on threads nor on the order of tiles.
#pragma once

#include "geometry/math.h"

#include <cstdint>

namespace lume::renderer {

using geometry::Vec2;

/// The random numbers of one sample of one pixel. Over the samples of a pixel each dimension is a
/// shuffled, Owen-scrambled Sobol (0,2)-sequence, so its points are well spread (Burley 2020,
/// "Practical Hash-based Owen Scrambling", JCGT 9(4)); between dimensions and pixels they are
/// independent.
class Sampler {
 public:
  Sampler(std::uint64_t seed, int x, int y, std::uint32_t sample);

  /// Two numbers in [0, 1) for the given purpose; the same call gives the same numbers.
  [[nodiscard]] Vec2 get_2d(std::uint32_t dimension) const;
  /// One number in [0, 1).
  [[nodiscard]] float get_1d(std::uint32_t dimension) const { return get_2d(dimension).x; }
  /// The numbers for a ray that this one spawns; children of other numbers are independent.
  [[nodiscard]] Sampler branch(std::uint32_t child) const;

 private:
  std::uint64_t key_;  ///< of the seed, the pixel and the branches taken so far
  std::uint32_t sample_;
};

}  // namespace lume::renderer
