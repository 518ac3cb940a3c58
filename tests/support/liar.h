// SPDX-License-Identifier: Apache-2.0
// A structure that is wrong on purpose, so that what looks for mistakes can be seen to find them.
#pragma once

#include "geometry/accelerators/accelerator.h"

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace lume::test {

/// Brute force, but for rays that `lies_about` chooses nothing is there.
class Liar final : public geometry::Accelerator {
 public:
  using Choice = std::function<bool(const geometry::Ray&)>;

  Liar(const geometry::World& world, const geometry::HoleTest* holes, Choice lies_about)
      : honest_(make_accelerator("brute-force", world, holes)),
        lies_about_(std::move(lies_about)) {}

  [[nodiscard]] std::optional<geometry::Hit> closest_hit(const geometry::Ray& ray) const override {
    return lies_about_(ray) ? std::nullopt : honest_->closest_hit(ray);
  }
  [[nodiscard]] bool any_hit(const geometry::Ray& ray) const override {
    return !lies_about_(ray) && honest_->any_hit(ray);
  }
  [[nodiscard]] geometry::AcceleratorStats stats() const override { return honest_->stats(); }

 private:
  std::unique_ptr<geometry::Accelerator> honest_;
  Choice lies_about_;
};

/// Chooses about one ray in `n`, by the bits of its direction.
inline Liar::Choice one_ray_in(unsigned n) {
  return [n](const geometry::Ray& ray) {
    const double mixed = std::abs(std::sin(12.9898 * ray.direction.x + 78.233 * ray.direction.y +
                                           37.719 * ray.direction.z)) *
                         43758.5453;
    return std::fmod(mixed, 1.0) * n < 1.0;
  };
}

}  // namespace lume::test
