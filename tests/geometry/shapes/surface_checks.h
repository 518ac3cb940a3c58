// SPDX-License-Identifier: Apache-2.0
// What the tests of several surfaces share.
#pragma once

#include "geometry/crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lume::test {

inline double angle_between(const geometry::DVec3& a, const geometry::DVec3& b) {
  return std::atan2(geometry::length(geometry::cross(a, b)), geometry::dot(a, b));
}

/// Of a surface that is crossed at a distance of 1 to 5 on the way down from (0, 0, 2).
template <class Surface>
void expect_that_broken_rays_hit_nothing(const Surface& surface) {
  using geometry::DVec3;
  constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double k_infinity = std::numeric_limits<double>::infinity();
  const DVec3 o(0.0, 0.0, 2.0);
  const DVec3 d(0.0, 0.0, -1.0);
  ASSERT_TRUE(surface.intersect({o, d}));
  for (const double bad : {k_nan, k_infinity, -k_infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      DVec3 broken = o;
      broken[axis] = bad;
      EXPECT_FALSE(surface.intersect({broken, d}));
      broken = d;
      broken[axis] = bad;
      EXPECT_FALSE(surface.intersect({o, broken}));
    }
  }
  EXPECT_FALSE(surface.intersect({o, DVec3(0.0)}));
  EXPECT_FALSE(surface.intersect({o, d, k_nan, 10.0}));
  EXPECT_FALSE(surface.intersect({o, d, 0.0, k_nan}));
  EXPECT_FALSE(surface.intersect({o, d, 5.0, 1.0}));
  EXPECT_FALSE(surface.intersect({o, d, 3.0, 1.0}));
}

}  // namespace lume::test
