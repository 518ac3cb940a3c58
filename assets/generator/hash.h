// SPDX-License-Identifier: Apache-2.0
// Random numbers that are functions of where they are used. There is no generator to advance, so a
// scene's parts may be made in any order, on any number of threads, and have the same bytes.
#pragma once

#include <cstdint>

namespace lume::generator {

/// The finalizer of SplitMix64 (Steele, Lea and Flood 2014, "Fast Splittable Pseudorandom Number
/// Generators"): every bit of the result depends on every bit of x.
[[nodiscard]] constexpr std::uint64_t hash(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// A number in [0, 1) for one purpose (`dimension`) of one thing (`index`).
[[nodiscard]] constexpr float random_unit(std::uint64_t index, std::uint64_t dimension) {
  return static_cast<float>(hash(index ^ hash(dimension)) >> 40) * 0x1p-24f;
}

/// The same in [-1, 1).
[[nodiscard]] constexpr float random_signed(std::uint64_t index, std::uint64_t dimension) {
  return 2.0f * random_unit(index, dimension) - 1.0f;
}

}  // namespace lume::generator
