// SPDX-License-Identifier: Apache-2.0
// What single rays bring back, for tests of integrators.
#pragma once

#include "renderer/integrator.h"
#include "renderer/prepared_scene.h"
#include "tests/support/near.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lume::renderer {

/// Mean over many samples of what one ray brings back.
inline Radiance mean_radiance(const shading::Scene& scene, const geometry::Ray& ray,
                              int samples = 1, int max_depth = 5, RayCounts* counts = nullptr) {
  const PreparedScene prepared(scene, "embree");
  const auto integrator = make_integrator("whitted", prepared, {max_depth});
  Radiance mean;
  Ledger all;
  for (int s = 0; s < samples; ++s) {
    const Radiance r =
        integrator->radiance(ray, Sampler(1, 0, 0, static_cast<std::uint32_t>(s)), all);
    mean.terms += Color(1.0f / static_cast<float>(samples)) * r.terms;
    mean.depth = std::max(mean.depth, r.depth);
    mean.alpha += r.alpha / static_cast<float>(samples);
  }
  if (counts != nullptr) *counts = all.counts;
  return mean;
}

using test::expect_near;

inline const geometry::Ray k_down_z{.origin = {0.1f, 0.05f, 5.0f}, .direction = {0, 0, -1}};

}  // namespace lume::renderer
