// SPDX-License-Identifier: Apache-2.0
// Seeded random cases for property tests.
#pragma once

#include "geometry/math.h"

#include <cmath>
#include <random>

namespace lume::test {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  float uniform(float low = 0.0f, float high = 1.0f) {
    // From the engine's bits, because the standard leaves distributions to the library.
    const auto bits = static_cast<float>(engine_() >> 8) * 0x1p-24f;
    return low + (high - low) * bits;
  }
  geometry::Vec2 square() { return {uniform(), uniform()}; }
  geometry::Vec3 cube(float half_size) {
    const float x = uniform(-half_size, half_size);
    const float y = uniform(-half_size, half_size);
    return {x, y, uniform(-half_size, half_size)};
  }
  /// Uniform on the unit sphere.
  geometry::Vec3 direction() {
    const float z = uniform(-1.0f, 1.0f);
    const float phi = uniform(0.0f, 2.0f * geometry::k_pi);
    const float r = std::sqrt(1.0f - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  /// A unit vector on +z's side, and not quite beside it.
  geometry::Vec3 upper_direction() {
    geometry::Vec3 v = direction();
    v.z = std::abs(v.z) + 1e-3f;
    return glm::normalize(v);
  }
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(engine_() % count); }

 private:
  std::mt19937 engine_;
};

}  // namespace lume::test
