// SPDX-License-Identifier: Apache-2.0
// Bounding volumes lose no ray that meets what is in them, at any size and distance, and keep off
// those that pass by.
#include "geometry/accelerators/bvh/box.h"
#include "geometry/accelerators/bvh/oriented_box.h"
#include "geometry/accelerators/bvh/sphere.h"
#include "tests/support/cases.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace lume::geometry::bvh {
namespace {

using test::Random;

double radius_of(const Bounds& box) { return 0.5 * length(DVec3(box.upper) - DVec3(box.lower)); }

constexpr double k_infinity = std::numeric_limits<double>::infinity();

Bounds bounds_of(const std::vector<Vec3>& points) {
  Bounds box;
  for (const Vec3& point : points) box.add(point);
  return box;
}

/// Points in a slab, a needle, a plane or a ball, turned anyhow, of any size and anywhere.
std::vector<Vec3> random_points(Random& random) {
  const float scale = std::exp2(random.uniform(-80.0f, 80.0f));
  const Vec3 offset = random.below(2) == 0 ? Vec3(0.0f) : random.cube(1e4f);
  const Vec3 thin(1.0f, random.below(3) == 0 ? 0.0f : random.uniform(),
                  std::exp2(random.uniform(-30.0f, 0.0f)));
  const Frame frame = make_frame(random.direction());
  std::vector<Vec3> points(1 + random.below(12));
  for (Vec3& point : points) point = scale * (offset + frame.to_world(thin * random.cube(1.0f)));
  return points;
}

/// A point of the convex hull, and that it is a mean is exact to double rounding.
DVec3 random_inside(Random& random, const std::vector<Vec3>& points) {
  const DVec3 a(points[random.below(static_cast<std::uint32_t>(points.size()))]);
  const DVec3 b(points[random.below(static_cast<std::uint32_t>(points.size()))]);
  const auto part = random.below(2) == 0 ? 0.0 : static_cast<double>(random.uniform());
  return a + part * (b - a);
}

template <class Volume>
class BoundingVolume : public ::testing::Test {};
using Volumes = ::testing::Types<Box, BoundingSphere, OrientedBox>;
TYPED_TEST_SUITE(BoundingVolume, Volumes);

TYPED_TEST(BoundingVolume, RaysThroughWhatIsInside_AreInsideThere) {
  Random random(1);
  for (int i = 0; i < test::cases(20000); ++i) {
    const std::vector<Vec3> points = random_points(random);
    const Bounds box = bounds_of(points);
    const TypeParam volume = TypeParam::around(box, points);
    const DVec3 target = random_inside(random, points);
    // From within, from near by and from far away; through the target at t = 1.
    const double size = std::exp2(static_cast<double>(random.uniform(-2.0f, 20.0f)));
    const DVec3 way(random.direction());
    ObjectRay ray;
    ray.origin = target + way * (size * (radius_of(box) + 1e-3 * length(target)));
    if (random.below(8) == 0) ray.origin[0] = target[0];  // across an axis
    ray.direction = target - ray.origin;
    const typename TypeParam::Ray ready(ray, box);
    const Interval1D inside = volume.clip(ready, 0.0, k_infinity);
    EXPECT_FALSE(inside.is_empty()) << i;
    EXPECT_LE(inside.enter, 1.0) << i;
    EXPECT_GE(inside.leave, 1.0) << i;
    if (this->HasFailure()) return;
    // A ray that ends just there, or begins there.
    EXPECT_FALSE(volume.clip(ready, 0.0, 1.0).is_empty()) << i;
    EXPECT_FALSE(volume.clip(ready, 1.0, k_infinity).is_empty()) << i;
    EXPECT_EQ(volume.clip(ready, 0.0, 1.0).leave, 1.0) << i;
  }
}

TYPED_TEST(BoundingVolume, RaysThatPassTheVolume_AreEmpty) {
  Random random(2);
  for (int i = 0; i < test::cases(20000); ++i) {
    const std::vector<Vec3> points = random_points(random);
    const Bounds box = bounds_of(points);
    const TypeParam volume = TypeParam::around(box, points);
    // No volume is wider than twice the box along three axes of its own, from any point inside.
    const DVec3 inside = random_inside(random, points);
    const double reach = 4.0 * radius_of(box) + 1e-6 * length(inside);
    const Frame frame = make_frame(random.direction());
    const DVec3 normal(frame.normal);
    ObjectRay ray;
    ray.origin = inside + reach * (normal - 3.0 * DVec3(frame.tangent));
    ray.direction = DVec3(frame.tangent);
    const auto misses = [&](double t_min, double t_max) {
      return volume.clip(typename TypeParam::Ray(ray, box), t_min, t_max).is_empty();
    };
    EXPECT_TRUE(misses(0.0, k_infinity)) << i;
    // Ahead of it, but the ray is over before, or begins behind.
    ray.origin = inside - 3.0 * reach * normal;
    ray.direction = reach * normal;
    EXPECT_FALSE(misses(0.0, k_infinity)) << i;
    EXPECT_TRUE(misses(0.0, 2.0)) << i;
    EXPECT_TRUE(misses(4.0, k_infinity)) << i;
    if (this->HasFailure()) return;
  }
}

TYPED_TEST(BoundingVolume, RayWithoutDirection_IsInsideWhereItStands) {
  const std::vector<Vec3> points = {{-1, -1, -1}, {1, 1, 1}, {1, -1, 0.5f}, {-1, 1, 0.3f}};
  const Bounds box = bounds_of(points);
  const TypeParam volume = TypeParam::around(box, points);
  const ObjectRay inside{DVec3(0.0), DVec3(0.0)};
  EXPECT_FALSE(volume.clip(typename TypeParam::Ray(inside, box), 0.0, k_infinity).is_empty());
}

TEST(BoundingSphere, Radius_IsThatOfTheFarthestPoint) {
  Random random(3);
  for (int i = 0; i < test::cases(20000); ++i) {
    const std::vector<Vec3> points = random_points(random);
    const Bounds box = bounds_of(points);
    const BoundingSphere sphere = BoundingSphere::around(box, points);
    double farthest = 0.0;
    for (const Vec3& point : points) {
      farthest = std::max(farthest, length(DVec3(point) - sphere.center));
    }
    EXPECT_GE(sphere.radius, farthest);
    EXPECT_LE(sphere.radius, farthest * (1.0 + 1e-14));
    // No worse than the sphere around the box.
    const double of_box = radius_of(box);
    EXPECT_LE(sphere.radius, of_box * (1.0 + 1e-14));
  }
}

TEST(BoundingSphere, CornersOfATetrahedron_HaveRittersSphereNearTheSmallest) {
  const std::vector<Vec3> points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_NEAR(BoundingSphere::around(bounds_of(points), points).radius, std::sqrt(3.0), 1e-12);
}

TEST(OrientedBox, ThinTurnedBox_HasItsOwnSizes) {
  Random random(4);
  for (int i = 0; i < test::cases(2000); ++i) {
    const DVec3 half(1.0, 0.4, 0.001);
    const Frame frame = make_frame(random.direction());
    std::vector<Vec3> points;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 signs((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                       (corner & 4) != 0 ? 1 : -1);
      points.push_back(Vec3(3, 4, 5) + frame.to_world(signs * Vec3(half)));
    }
    const Bounds box = bounds_of(points);
    const OrientedBox turned = OrientedBox::around(box, points);
    const double expected = 4.0 * (half.x * half.y + half.y * half.z + half.z * half.x);
    EXPECT_LE(half_area(turned), half_area(box) * (1.0 + 1e-12));
    // Along the axes of space already, or found by the covariance.
    EXPECT_NEAR(half_area(turned), expected, 0.01 * expected);
    for (const Vec3& point : points) {
      for (int k = 0; k < 3; ++k) {
        const double height = dot(DVec3(turned.axes[k]), DVec3(point));
        EXPECT_GE(height, turned.lower[k] - 1e-13);
        EXPECT_LE(height, turned.upper[k] + 1e-13);
      }
    }
  }
}

TEST(OrientedBox, Triangle_IsHeldInItsPlane) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 2, 3}, {3, -1, 2}};
  const OrientedBox box = OrientedBox::around(bounds_of(points), points);
  const DVec3 size = box.upper - box.lower;
  EXPECT_LT(std::min({size.x, size.y, size.z}), 1e-6);
  EXPECT_LT(half_area(box), 0.6 * half_area(bounds_of(points)));
}

}  // namespace
}  // namespace lume::geometry::bvh
