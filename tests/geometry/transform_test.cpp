// SPDX-License-Identifier: Apache-2.0
#include "geometry/transform.h"

#include "tests/support/worlds.h"

#include <gtest/gtest.h>

namespace lume::geometry {
namespace {

using test::Random;

TEST(Transform, ThereAndBack_IsTheIdentity) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Transform transform(test::random_transform(random));
    const DVec3 p(random.cube(100.0f));
    ASSERT_LT(length(transform.point_to_object(transform.point_to_world(p)) - p), 1e-11);
    ASSERT_LT(length(transform.vector_to_object(transform.vector_to_world(p)) - p), 1e-11);
  }
}

TEST(Transform, Normal_StaysPerpendicularToTheSurfaceAndOnItsSide) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Transform transform(test::random_transform(random));
    const DVec3 a(random.direction());
    const DVec3 b(random.direction());
    const DVec3 n = cross(a, b);
    const DVec3 world_n = transform.normal_to_world(n);
    ASSERT_NEAR(dot(world_n, transform.vector_to_world(a)), 0.0, 1e-12);
    ASSERT_NEAR(dot(world_n, transform.vector_to_world(b)), 0.0, 1e-12);
    // Mirrored or not, what lay on the normal's side lies there still.
    ASSERT_GT(dot(world_n, transform.vector_to_world(n)), 0.0);
  }
}

TEST(Transform, Bounds_HoldEveryTransformedPoint) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Transform transform(test::random_transform(random));
    Bounds bounds;
    bounds.add(random.cube(2.0f));
    bounds.add(random.cube(2.0f));
    const Bounds moved = transform.bounds_to_world(bounds);
    for (int k = 0; k < 20; ++k) {
      const Vec3 weight = (random.cube(1.0f) + 1.0f) * 0.5f;
      const Vec3 inside = bounds.lower + weight * bounds.size();
      const Vec3 p(transform.point_to_world(DVec3(inside)));
      ASSERT_TRUE(glm::all(glm::lessThanEqual(moved.lower - 1e-4f, p)));
      ASSERT_TRUE(glm::all(glm::lessThanEqual(p, moved.upper + 1e-4f)));
    }
  }
}

TEST(Transform, FlatAndInfiniteMatrices_AreNotInvertible) {
  EXPECT_TRUE(Transform::is_invertible(DMat4(1.0)));
  DMat4 mirror(1.0);
  mirror[1][1] = -3.0;
  EXPECT_TRUE(Transform::is_invertible(mirror));
  DMat4 flat(1.0);
  flat[2][2] = 0.0;
  EXPECT_FALSE(Transform::is_invertible(flat));
  DMat4 sheared_flat(1.0);
  sheared_flat[1] = sheared_flat[0];
  EXPECT_FALSE(Transform::is_invertible(sheared_flat));
  DMat4 infinite(1.0);
  infinite[3][0] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(Transform::is_invertible(infinite));
  DMat4 tiny(1e-5);
  tiny[3][3] = 1.0;
  EXPECT_TRUE(Transform::is_invertible(tiny));
}

TEST(Transform, EmptyBounds_StayEmpty) {
  EXPECT_TRUE(Transform().bounds_to_world(Bounds{}).is_empty());
}

}  // namespace
}  // namespace lume::geometry
