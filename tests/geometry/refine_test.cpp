// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine.h"

#include "tests/geometry/shapes/high_precision.h"
#include "tests/support/random.h"
#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lume::geometry {
namespace {

using test::Random;

/// Cramer's rule on o + t d = a + u (b - a) + v (c - a), in 113-bit arithmetic.
struct Oracle {
  Oracle(const DVec3& origin, const DVec3& direction, const DVec3& a, const DVec3& b,
         const DVec3& c) {
    using Vector = test::RealVector;
    const auto triple = [](const Vector& x, const Vector& y, const Vector& z) {
      return dot(x, cross(y, z));
    };
    const Vector minus_d = Vector() - Vector(direction);
    const Vector e1 = Vector(b) - Vector(a);
    const Vector e2 = Vector(c) - Vector(a);
    const Vector s = Vector(origin) - Vector(a);
    determinant = triple(minus_d, e1, e2);
    if (determinant == 0) return;
    t = static_cast<double>(triple(s, e1, e2) / determinant);
    u = static_cast<double>(triple(minus_d, s, e2) / determinant);
    v = static_cast<double>(triple(minus_d, e1, s) / determinant);
  }

  test::Real determinant = 0;
  double t = 0.0;
  double u = 0.0;
  double v = 0.0;
};

TEST(IntersectTriangle, RandomRays_AgreeWithQuadruplePrecision) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const DVec3 a(random.cube(1.0f));
    const DVec3 b(random.cube(1.0f));
    const DVec3 c(random.cube(1.0f));
    const DVec3 origin(random.cube(4.0f));
    const DVec3 direction = DVec3(random.cube(1.0f)) - origin;
    const Oracle oracle(origin, direction, a, b, c);
    const double slack = std::min({oracle.u, oracle.v, 1.0 - oracle.u - oracle.v});
    const TriangleCrossing crossing = nearest_on_triangle(origin, direction, a, b, c);
    if (std::abs(slack) > 1e-12) {
      ASSERT_EQ(crossing.inside, slack > 0.0) << "case " << i;
    }
    if (!crossing.inside) continue;
    ++hits;
    const double shear = 1e-12 / std::max(1e-3, std::abs(static_cast<double>(oracle.determinant)));
    ASSERT_NEAR(crossing.t, oracle.t, shear) << "case " << i;
    ASSERT_NEAR(crossing.u, oracle.u, shear) << "case " << i;
    ASSERT_NEAR(crossing.v, oracle.v, shear) << "case " << i;
  }
  EXPECT_GT(hits, 1000);
}

TEST(IntersectTriangle, RaysThroughSharedEdges_NeverSlipBetweenTheTriangles) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const DVec3 a(random.cube(1.0f));
    const DVec3 b(random.cube(1.0f));
    const DVec3 c(random.cube(1.0f));
    const DVec3 along(b - a);
    const DVec3 d = a + b - c;  // across the edge a-b
    const DVec3 on_edge = a + along * static_cast<double>(random.uniform());
    const DVec3 origin(random.cube(3.0f));
    const DVec3 direction(Vec3(on_edge - origin));  // rounded to float: not quite on the edge
    const TriangleCrossing one = nearest_on_triangle(origin, direction, a, b, c);
    const TriangleCrossing other = nearest_on_triangle(origin, direction, b, a, d);
    ASSERT_TRUE(one.inside || other.inside) << "case " << i;
  }
}

TEST(IntersectTriangle, RaysThroughACorner_MeetOneOfTheTrianglesAroundIt) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const DVec3 hub(random.cube(1.0f));
    const DVec3 b(random.cube(1.0f));
    const DVec3 c(random.cube(1.0f));
    const DVec3 d = hub + (hub - b) + (hub - c);
    const DVec3 origin(random.cube(3.0f));
    const DVec3 direction(Vec3(hub - origin));
    ASSERT_TRUE(nearest_on_triangle(origin, direction, hub, b, c).inside ||
                nearest_on_triangle(origin, direction, hub, c, d).inside ||
                nearest_on_triangle(origin, direction, hub, d, b).inside)
        << "case " << i;
  }
}

TEST(IntersectTriangle, MissedTriangle_GivesAPointInIt) {
  Random random(4);
  int misses = 0;
  for (int i = 0; i < 5000; ++i) {
    const DVec3 a(random.cube(1.0f));
    const DVec3 b(random.cube(1.0f));
    const DVec3 c(random.cube(1.0f));
    const TriangleCrossing crossing =
        nearest_on_triangle(DVec3(random.cube(3.0f)), DVec3(random.direction()), a, b, c);
    if (!crossing.inside) ++misses;
    ASSERT_GE(crossing.u, 0.0);
    ASSERT_GE(crossing.v, 0.0);
    ASSERT_LE(crossing.u + crossing.v, 1.0 + 1e-12);
    ASSERT_TRUE(std::isfinite(crossing.t));
  }
  EXPECT_GT(misses, 1000);
}

TEST(IntersectTriangle, DegenerateTriangle_IsNotMetAndStaysFinite) {
  const DVec3 a(1, 2, 3);
  const TriangleCrossing point = nearest_on_triangle({0, 0, 0}, {1, 2, 3}, a, a, a);
  EXPECT_FALSE(point.inside);
  EXPECT_TRUE(std::isfinite(point.t + point.u + point.v));
  const TriangleCrossing line = nearest_on_triangle({0, 0, 0}, {1, 2, 3}, a, a * 2.0, a * 3.0);
  EXPECT_FALSE(line.inside);
  EXPECT_TRUE(std::isfinite(line.t + line.u + line.v));
}

TEST(Refine, TransformedInstance_EqualsTransformingTheTriangle) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    World world;
    const DMat4 matrix = test::random_transform(random);
    test::add_instance(world, test::triangle_soup(random, 1, 1.0f, 2.0f), matrix);
    const auto corners = test::mesh_of(world).corners(0);
    std::array<DVec3, 3> moved{};
    for (std::size_t k = 0; k < 3; ++k) moved[k] = DVec3(matrix * glm::dvec4(corners[k], 1.0));
    Ray ray;
    ray.origin = random.cube(20.0f);
    ray.direction = Vec3((moved[0] + moved[1] + moved[2]) / 3.0) - ray.origin;
    const Crossing inside_object = refine(world, ray, {0, 0, 0}, nullptr);
    const Oracle oracle(DVec3(ray.origin), DVec3(ray.direction), moved[0], moved[1], moved[2]);
    ASSERT_NEAR(inside_object.t, oracle.t, 1e-7) << "case " << i;
    ASSERT_NEAR(inside_object.u, oracle.u, 1e-7) << "case " << i;
  }
}

}  // namespace
}  // namespace lume::geometry
