// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace lume::renderer {

/// Rays traced, by purpose.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;

  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    reflection += other.reflection;
    refraction += other.refraction;
    return *this;
  }
  [[nodiscard]] std::uint64_t total() const { return camera + shadow + reflection + refraction; }
};

}  // namespace lume::renderer
