// SPDX-License-Identifier: Apache-2.0
#include "assets/generator/noise.h"

#include "assets/generator/hash.h"

#include <cmath>

namespace lume::generator {
namespace {

using geometry::Vec3;

/// The key of a lattice point: its coordinates side by side, 21 bits each.
std::uint64_t lattice_key(const glm::ivec3& cell) {
  constexpr std::uint64_t k_mask = (1u << 21) - 1;
  const auto bits = [](int i) { return static_cast<std::uint64_t>(i) & k_mask; };
  return bits(cell.x) | bits(cell.y) << 21 | bits(cell.z) << 42;
}

/// What the lattice point's random gradient contributes at `offset` from it. The gradient is
/// uniform in a cube and not on a sphere: a little less even, and much cheaper.
float slope(const glm::ivec3& cell, const Vec3& offset, std::uint64_t key) {
  const std::uint64_t bits = hash(lattice_key(cell) ^ key);
  const auto component = [bits](int shift) {
    return static_cast<float>((bits >> shift) & 0xffffu) * 0x1p-15f - 1.0f;
  };
  return dot(Vec3(component(0), component(16), component(32)), offset);
}

}  // namespace

float noise(const Vec3& p, std::uint64_t seed) {
  const Vec3 base = glm::floor(p);
  const glm::ivec3 cell(base);
  const Vec3 f = p - base;
  const Vec3 fade = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  const std::uint64_t key = hash(seed);
  const auto corner = [&](int x, int y, int z) {
    return slope(cell + glm::ivec3(x, y, z), f - Vec3(x, y, z), key);
  };
  const auto edge = [&](int y, int z) {
    return glm::mix(corner(0, y, z), corner(1, y, z), fade.x);
  };
  const float lower = glm::mix(edge(0, 0), edge(1, 0), fade.y);
  const float upper = glm::mix(edge(0, 1), edge(1, 1), fade.y);
  return 1.5f * glm::mix(lower, upper, fade.z);
}

float fractal_noise(Vec3 p, int octaves, float gain, std::uint64_t seed) {
  float sum = 0.0f;
  float height = 1.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += height * noise(p, seed + static_cast<std::uint64_t>(octave));
    height *= gain;
    p *= 2.0f;
  }
  return sum;
}

}  // namespace lume::generator
