// SPDX-License-Identifier: Apache-2.0
#include "renderer/pixel_filter.h"

#include "tests/support/chi_squared.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lume::renderer {
namespace {

using Kind = PixelFilter::Kind;
constexpr Kind k_kinds[] = {Kind::box, Kind::triangle, Kind::gaussian, Kind::blackman_harris};

TEST(PixelFilter, Samples_FollowTheFilter) {
  constexpr int k_cells = 60;
  constexpr int k_samples = 200000;
  test::Random random(1);
  for (const Kind kind : k_kinds) {
    for (const float radius : {0.0f, 0.8f, 2.0f}) {
      const PixelFilter filter(kind, radius);
      std::vector<double> counts(k_cells, 0.0);
      std::vector<double> expected(k_cells, 0.0);
      double total = 0.0;
      for (std::size_t i = 0; i < k_cells; ++i) {
        for (int k = 0; k < 16; ++k) {
          const double x = ((static_cast<double>(i) + (k + 0.5) / 16.0) / k_cells * 2.0 - 1.0) *
                           static_cast<double>(filter.radius());
          expected[i] += static_cast<double>(filter.evaluate(static_cast<float>(x)));
        }
        total += expected[i];
      }
      for (double& e : expected) e *= k_samples / total;
      for (int i = 0; i < k_samples; ++i) {
        const Vec2 offset = filter.sample(random.square());
        const float unit = 0.5f + 0.5f * offset.x / filter.radius();
        const auto cell = static_cast<int>(unit * static_cast<float>(k_cells));
        counts[static_cast<std::size_t>(std::clamp(cell, 0, k_cells - 1))] += 1.0;
      }
      test::expect_chi_squared(counts, expected);
    }
  }
}

TEST(PixelFilter, SamplesAndSupport_StayWithinTheRadius) {
  test::Random random(2);
  for (const Kind kind : k_kinds) {
    const PixelFilter filter(kind);
    EXPECT_NEAR(filter.evaluate(filter.radius() * 1.001f), 0.0f, 1e-6f);
    for (int i = 0; i < 1000; ++i) {
      const Vec2 offset = glm::abs(filter.sample(random.square()));
      ASSERT_LE(std::max(offset.x, offset.y), filter.radius() * 1.0001f);
    }
    EXPECT_NEAR(filter.sample({0.5f, 0.5f}).x, 0.0f, 1e-4f) << "symmetric";
  }
}

TEST(PixelFilter, Names_AreInTheOrderOfKinds) {
  ASSERT_EQ(PixelFilter::names().size(), std::size(k_kinds));
  EXPECT_EQ(PixelFilter::names()[static_cast<std::size_t>(Kind::triangle)], "triangle");
}

}  // namespace
}  // namespace lume::renderer
