// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/tight_box.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

/// Exact: the nearest and the farthest point of the box are on different sides of the sphere.
struct SphereOracle {
  DVec3 center;
  double radius;
  int* calls;

  bool operator()(const DVec3& lower, const DVec3& upper) const {
    ++*calls;
    const DVec3 nearest = glm::clamp(center, lower, upper) - center;
    const DVec3 farthest = glm::max(glm::abs(lower - center), glm::abs(upper - center));
    return length(nearest) <= radius && length(farthest) >= radius;
  }
};

TEST(TightBox, Sphere_IsEnclosedToHalfAPercent) {
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const DVec3 center(random.cube(1.0f));
    const double radius = 0.1 + static_cast<double>(random.uniform());
    int calls = 0;
    const auto box = tight_box({DVec3(-5.0), DVec3(7.0)}, SphereOracle{center, radius, &calls});
    ASSERT_TRUE(box.has_value());
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(box->lower[axis], center[axis] - radius);
      EXPECT_GE(box->upper[axis], center[axis] + radius);
      EXPECT_NEAR(box->lower[axis], center[axis] - radius, 0.012 * radius);
      EXPECT_NEAR(box->upper[axis], center[axis] + radius, 0.012 * radius);
    }
    EXPECT_LT(calls, 20000);
  }
}

TEST(TightBox, SmallSphereInHugeBox_IsEnclosedTightly) {
  int calls = 0;
  const auto box = tight_box({DVec3(-1e9), DVec3(1e9)}, SphereOracle{DVec3(3.0), 1.0, &calls});
  ASSERT_TRUE(box.has_value());
  EXPECT_NEAR(box->lower.x, 2.0, 0.02);
  EXPECT_NEAR(box->upper.z, 4.0, 0.02);
}

TEST(TightBox, BoxCutsTheSurface_SideStaysWhereItWas) {
  int calls = 0;
  const auto box =
      tight_box({DVec3(-2.0, -2.0, 0.0), DVec3(0.5, 2.0, 2.0)}, SphereOracle{{}, 1.0, &calls});
  ASSERT_TRUE(box.has_value());
  EXPECT_EQ(box->lower.z, 0.0);
  EXPECT_EQ(box->upper.x, 0.5);
  EXPECT_NEAR(box->upper.z, 1.0, 0.01);
}

TEST(TightBox, NothingInside_GivesNoBox) {
  int calls = 0;
  EXPECT_FALSE(tight_box({DVec3(2.0), DVec3(3.0)}, SphereOracle{{}, 1.0, &calls}).has_value());
  // Only small boxes are known to be empty.
  const auto may_contain = [](const DVec3& lower, const DVec3& upper) {
    return length(upper - lower) > 0.3;
  };
  EXPECT_FALSE(tight_box({DVec3(0.0), DVec3(1.0)}, may_contain).has_value());
}

TEST(TightBox, NothingIsKnown_GivesTheWholeBoxSoon) {
  int calls = 0;
  const auto box = tight_box({DVec3(-1.0), DVec3(2.0)}, [&](const DVec3&, const DVec3&) {
    ++calls;
    return true;
  });
  ASSERT_TRUE(box.has_value());
  EXPECT_EQ(box->lower, DVec3(-1.0));
  EXPECT_EQ(box->upper, DVec3(2.0));
  EXPECT_LT(calls, 1000);
}

TEST(TightBox, PredicateThatCutsItsBox_IsTakenAtItsWord) {
  const auto only_a_slab = [](DVec3& lower, DVec3& upper) {
    lower.y = std::fmax(lower.y, 0.123);
    upper.y = std::fmin(upper.y, 0.125);
    return lower.y <= upper.y;
  };
  const auto box = tight_box({DVec3(-1.0), DVec3(1.0)}, only_a_slab);
  ASSERT_TRUE(box.has_value());
  EXPECT_EQ(box->lower, DVec3(-1.0, 0.123, -1.0));
  EXPECT_EQ(box->upper, DVec3(1.0, 0.125, 1.0));
}

}  // namespace
}  // namespace lume::geometry
