// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/hole_test.h"
#include "shading/material_point.h"

namespace lume::shading {

/// Masked-out texels are holes for every kind of ray (alphaMode MASK).
class AlphaMask final : public geometry::HoleTest {
 public:
  explicit AlphaMask(const Scene& scene) : scene_(scene) {}
  [[nodiscard]] bool is_hole(const geometry::Hit& hit, Vec2 uv) const override {
    return evaluate_coverage(scene_, hit, uv) <= 0.0f;
  }

 private:
  const Scene& scene_;
};

}  // namespace lume::shading
