// SPDX-License-Identifier: Apache-2.0
#include "shading/warp.h"

#include "tests/support/chi_squared.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::shading {
namespace {

TEST(CosineHemisphere, Samples_FollowTheCosine) {
  constexpr int k_samples = 200000;
  test::Random random(1);
  test::SphereCells cells(16, 24, 0.0);
  for (int i = 0; i < k_samples; ++i) {
    const geometry::Vec3 w = sample_cosine_hemisphere(random.square());
    ASSERT_NEAR(length(w), 1.0f, 1e-5f);
    cells.count(w);
  }
  const double integral =
      cells.expect([](double, double, double z) { return z / M_PI; }, k_samples, 8);
  EXPECT_NEAR(integral, 1.0, 1e-3);
  cells.test();
}

TEST(CosinePower, Samples_FollowThePower) {
  constexpr int k_samples = 200000;
  for (const float n : {0.0f, 1.0f, 7.5f, 200.0f, 1e6f}) {
    test::Random random(2);
    // The cap that all but one in 10^5 samples fall into.
    const double edge = std::pow(1e-5, 1.0 / (static_cast<double>(n) + 1.0));
    test::SphereCells cells(16, 24, edge);
    int inside = 0;
    for (int i = 0; i < k_samples; ++i) {
      const geometry::Vec3 w = sample_cosine_power(random.square(), n);
      ASSERT_NEAR(length(w), 1.0f, 1e-6f);
      // Of a narrow lobe only the sine can tell, so z comes from it.
      const double x = w.x;
      const double y = w.y;
      const glm::dvec3 exact(x, y, std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
      if (exact.z < edge) continue;
      ++inside;
      cells.count(exact);
    }
    EXPECT_GE(inside, k_samples - 20);
    const auto density = [n](double, double, double z) {
      return (n + 1.0) / (2.0 * M_PI) * std::pow(z, static_cast<double>(n));
    };
    EXPECT_NEAR(cells.expect(density, k_samples, 8), 1.0, 2e-3) << "n " << n;
    cells.test();
  }
}

TEST(CosinePower, InfinitePower_IsTheAxis) {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const geometry::Vec3 w =
        sample_cosine_power(random.square(), std::numeric_limits<float>::infinity());
    ASSERT_EQ(w, geometry::Vec3(0, 0, 1));
  }
}

}  // namespace
}  // namespace lume::shading
