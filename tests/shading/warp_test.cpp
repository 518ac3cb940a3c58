// SPDX-License-Identifier: Apache-2.0
#include "shading/warp.h"

#include "tests/support/chi_squared.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

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

}  // namespace
}  // namespace lume::shading
