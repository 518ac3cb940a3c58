// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/math.h"

#include <gtest/gtest.h>

namespace lume::test {

/// Vectors and colours, component by component.
inline void expect_near(const geometry::Vec3& a, const geometry::Vec3& b, float tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace lume::test
