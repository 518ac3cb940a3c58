// SPDX-License-Identifier: Apache-2.0
// Smooth noise in space, for surfaces and paths that no compass drew.
#pragma once

#include "geometry/math.h"

namespace lume::generator {

/// Gradient noise (Perlin 1985, "An Image Synthesizer", with the quintic fade of Perlin 2002,
/// "Improving Noise"): mostly within [-1, 1], 0 on average, with features about 1 wide and
/// continuous second derivatives. Coordinates must be below 2^20 in magnitude.
[[nodiscard]] float noise(const geometry::Vec3& p, std::uint64_t seed);

/// Noise of each of `octaves` scales, every one half as wide and `gain` times as high as the one
/// before.
[[nodiscard]] float fractal_noise(geometry::Vec3 p, int octaves, float gain, std::uint64_t seed);

}  // namespace lume::generator
