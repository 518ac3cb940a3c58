// SPDX-License-Identifier: Apache-2.0
// Implicit surfaces where they are hard to meet: tangents, singular points, formulas without
// values, broken rays.
#include "geometry/shapes/cylindrical_point.h"
#include "tests/geometry/shapes/implicit_rays.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace lume::geometry {
namespace {

using test::all_crossings;
using test::any_ray;
using test::Random;
using test::ray_of;
using test::surface_of;

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

TEST(ImplicitSurface, ShorterRay_MeetsTheSameRootsOrNone) {
  const ImplicitSurface surface = surface_of("x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", 3.0);
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    ObjectRay ray = any_ray(random, 3.0);
    const auto all = all_crossings(surface, ray);
    for (const double t : all) {
      ray.t_min = 0.0;
      ray.t_max = t;
      ASSERT_EQ(surface.intersect(ray)->t, all.front());
      ray.t_min = t;
      ASSERT_EQ(surface.intersect(ray)->t, t);
      ray.t_max = k_infinity;
      ASSERT_EQ(surface.intersect(ray)->t, t);
    }
    if (all.empty()) continue;
    ray.t_min = 0.0;
    ray.t_max = std::nextafter(all.front(), 0.0);
    ASSERT_FALSE(surface.intersect(ray).has_value());
  }
}

TEST(ImplicitSurface, RayFromFarAway_StillMeetsTheSphere) {
  const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1", 2.0);
  Random random(15);
  for (int i = 0; i < 2000; ++i) {
    const DVec3 target = 0.9 * DVec3(random.direction());
    const ObjectRay ray = ray_of(target + 1e6 * DVec3(random.direction()), {0.0, 0.0, 0.0});
    const auto crossing = surface.intersect(ray_of(ray.origin, target - ray.origin));
    ASSERT_TRUE(crossing.has_value());
    const DVec3 p = ray.origin + crossing->t * (target - ray.origin);
    EXPECT_NEAR(length(p), 1.0, 1e-9);
    EXPECT_NEAR(length(surface.point(p, *crossing).position), 1.0, 1e-15);
  }
}

TEST(ImplicitSurface, TinyAndHugeSpheres_AreMet) {
  for (const double radius : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    char text[64];
    std::snprintf(text, sizeof text, "x^2 + y^2 + z^2 - %.17g^2", radius);
    const ImplicitSurface surface = surface_of(text, 2.0 * radius);
    const auto found = all_crossings(
        surface, ray_of(DVec3(0.1, 0.2, 5.0) * radius, DVec3(0.0, 0.0, -0.01 * radius)));
    ASSERT_EQ(found.size(), 2U) << radius;
    const double z = std::sqrt(1.0 - 0.05);
    EXPECT_NEAR(found[0], 100.0 * (5.0 - z), 1e-10);
    EXPECT_NEAR(found[1], 100.0 * (5.0 + z), 1e-10);
  }
}

TEST(ImplicitSurface, StartOnTheSurface_FindsTheOtherSide) {
  const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1", 2.0);
  Random random(16);
  for (int i = 0; i < 2000; ++i) {
    const DVec3 start = normalize(DVec3(random.direction()));
    const DVec3 end = normalize(DVec3(random.direction()));
    if (length(end - start) < 0.01) continue;
    ObjectRay ray = ray_of(start, end - start);
    ray.t_min = 1e-9;
    const auto found = all_crossings(surface, ray);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0], 1.0, 1e-9);
  }
}

TEST(ImplicitSurface, GrazingRays_AreToldApartBesideTheTangent) {
  const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1", 2.0);
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14}) {
    const DVec3 along(1.0, 0.0, 0.0);
    EXPECT_EQ(all_crossings(surface, ray_of({-5.0, 1.0 + gap, 0.0}, along)).size(), 0U) << gap;
    EXPECT_GE(all_crossings(surface, ray_of({-5.0, 1.0 - gap, 0.0}, along)).size(), 2U) << gap;
  }
  const auto tangent = surface.intersect(ray_of({-5.0, 1.0, 0.0}, {1.0, 0.0, 0.0}));
  ASSERT_TRUE(tangent.has_value());  // f is 0 to rounding there
  EXPECT_NEAR(tangent->t, 5.0, 1e-7);
}

TEST(ImplicitSurface, RayThroughTheConesApex_MeetsItOnce) {
  const ImplicitSurface surface = surface_of("x^2 + z^2 - y^2", 1.0);
  const auto crossing = surface.intersect(ray_of({3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}));
  ASSERT_TRUE(crossing.has_value());
  EXPECT_NEAR(crossing->t, 3.0, 1e-7);
  EXPECT_TRUE(std::isfinite(surface.point({}, *crossing).normal.y));
}

TEST(ImplicitSurface, TouchWithoutCrossing_IsNone) {
  const ImplicitSurface kink = surface_of("abs(x - 0.1) + 1e-9", 1.0);
  EXPECT_FALSE(kink.intersect(ray_of({3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})).has_value());
  const ImplicitSurface above = surface_of("x^2 + 1e-12", 1.0);
  EXPECT_FALSE(above.intersect(ray_of({3.0, 0.1, 0.0}, {-1.0, 0.0, 0.0})).has_value());
}

TEST(ImplicitSurface, Poles_AreNoCrossings) {
  for (const char* text : {"1/x", "1/x^3", "x/abs(x)", "tan(2*x) + 0*y", "1/(x - 0.1)", "atan(1/x)",
                           "(x + 2)/(x*y - 0.01)", "log(x) + 1/(x-0.5)^3 - 1e9*x"}) {
    const ImplicitSurface surface = surface_of(text, 1.0);
    for (const double t : all_crossings(surface, ray_of({3.0, 0.31, 0.17}, {-1.0, 0.01, 0.02}))) {
      const DVec3 p = DVec3(3.0, 0.31, 0.17) + t * DVec3(-1.0, 0.01, 0.02);
      EXPECT_LT(std::abs(Expression(text).evaluate(p.x, p.y, p.z)), 1e-3) << text << " at " << p.x;
    }
  }
  EXPECT_TRUE(
      all_crossings(surface_of("1/x", 1.0), ray_of({3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})).empty());
}

TEST(ImplicitSurface, FormulaWithoutValuesInPlaces_IsMetWhereItHasSome) {
  const ImplicitSurface surface = surface_of("sqrt(x) - 0.5 + 0*y", 1.0);
  const auto from_above = all_crossings(surface, ray_of({3.0, 0.1, 0.1}, {-1.0, 0.0, 0.0}));
  ASSERT_EQ(from_above.size(), 1U);
  EXPECT_NEAR(from_above[0], 2.75, 1e-12);
  const auto from_below = all_crossings(surface, ray_of({-3.0, 0.1, 0.1}, {1.0, 0.0, 0.0}));
  ASSERT_EQ(from_below.size(), 1U);
  EXPECT_NEAR(from_below[0], 3.25, 1e-12);
  const ImplicitSurface nowhere = surface_of("sqrt(-1 - x^2)", 1.0);
  EXPECT_TRUE(nowhere.is_empty());
  EXPECT_FALSE(nowhere.intersect(ray_of({3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})).has_value());
}

TEST(ImplicitSurface, FormulaWithoutSurface_IsNeverMet) {
  for (const char* text : {"1", "x^2 + 1", "exp(x + y)", "-0.001", "0/0", "log(-1)", "1/0"}) {
    const ImplicitSurface surface = surface_of(text, 1.0);
    EXPECT_TRUE(surface.is_empty()) << text;
    EXPECT_TRUE(std::isfinite(surface.support({1.0, -2.0, 3.0})));
    EXPECT_FALSE(surface.intersect(ray_of({3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})).has_value());
  }
}

TEST(ImplicitSurface, UglyFormulas_EndSoon) {
  for (const char* text : {"0", "x - x", "max(x^2 + y^2 - 0.5, 0)", "(x^2 + y^2 + z^2 - 0.5)^2",
                           "sin(1/x)", "sin(1e9*x)", "exp(1e3*x) - exp(1e3*x)", "x^1024 - y^1024",
                           "tan(1e6*x*y)", "x^y^z - 0.5", "sqrt(x)*0", "1e300*x*1e300 - y"}) {
    const ImplicitSurface surface = surface_of(text, 1.0);
    Random random(17);
    for (int i = 0; i < 20; ++i) {
      const ObjectRay ray = any_ray(random, 1.0);
      const auto crossing = surface.intersect(ray);
      EXPECT_TRUE(!crossing || ray.contains(crossing->t)) << text;
    }
  }
}

TEST(ImplicitSurface, BrokenRays_MeetNothing) {
  const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1", 2.0);
  const DVec3 inside(0.1, 0.2, 0.3);
  for (const double bad : {k_nan, k_infinity, -k_infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      DVec3 vector(0.5, -0.5, 1.0);
      vector[axis] = bad;
      EXPECT_FALSE(surface.intersect(ray_of(vector, {0.0, 1.0, 0.0})).has_value());
      EXPECT_FALSE(surface.intersect(ray_of(inside, vector)).has_value());
    }
    ObjectRay ray = ray_of(inside, {0.0, 1.0, 0.0});
    ray.t_min = bad;
    EXPECT_EQ(surface.intersect(ray).has_value(), bad == -k_infinity);
  }
  EXPECT_FALSE(surface.intersect(ray_of(inside, {0.0, 0.0, 0.0})).has_value());
  EXPECT_FALSE(surface.intersect(ray_of({0.6, 0.8, 0.0}, {0.0, 0.0, 0.0})).has_value());
}

TEST(ImplicitSurface, Box_CutsTheSurface) {
  const ImplicitSurface surface(Expression("x^2 + y^2 + z^2 - 1"), DVec3(-2.0, -2.0, 0.0),
                                DVec3(2.0, 0.5, 2.0));
  const auto from_front = all_crossings(surface, ray_of({0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}));
  EXPECT_EQ(from_front.size(), 1U);
  EXPECT_TRUE(all_crossings(surface, ray_of({0.1, 0.6, 5.0}, {0.0, 0.0, -1.0})).empty());
  // So little aside that the quotients of a slab overflow.
  EXPECT_EQ(all_crossings(surface, ray_of({0.1, 0.2, 5.0}, {1e-310, 0.0, -1.0})).size(), 1U);
  // In the very side of the box a surface is still in the box.
  const ImplicitSurface floor(Expression("y"), DVec3(-1.0, 0.0, -1.0), DVec3(1.0));
  Random random(18);
  for (int i = 0; i < 1000; ++i) {
    const DVec3 target(random.uniform(-0.9f, 0.9f), 0.0, random.uniform(-0.9f, 0.9f));
    const DVec3 from = DVec3(random.cube(2.0f)) + DVec3(0.0, 3.0, 0.0);
    EXPECT_EQ(all_crossings(floor, ray_of(from, target - from)).size(), 1U);
  }
}

TEST(ImplicitSurface, Support_IsThatOfTheTightBox) {
  const ImplicitSurface sphere = surface_of("x^2 + y^2 + z^2 - 1", 10.0);
  for (int axis = 0; axis < 3; ++axis) {
    DVec3 direction(0.0);
    direction[axis] = 2.0;
    EXPECT_GE(sphere.support(direction), 2.0);
    EXPECT_LE(sphere.support(direction), 2.02);
    EXPECT_GE(sphere.support(-direction), 2.0);
    EXPECT_LE(sphere.support(-direction), 2.02);
  }
  EXPECT_GE(sphere.support({1.0, 1.0, 1.0}), 3.0);
  const ImplicitSurface torus = surface_of("(sqrt(x^2 + z^2) - 1)^2 + y^2 - 0.09", 4.0);
  EXPECT_NEAR(torus.support({0.0, 1.0, 0.0}), 0.3, 0.003);
  EXPECT_NEAR(torus.support({-1.0, 0.0, 0.0}), 1.3, 0.013);
}

TEST(ImplicitSurface, Point_HasTruePartialDerivatives) {
  // An egg, upright and inside out: the front faces the axis then.
  for (const double side : {1.0, -1.0}) {
    const std::string sign = side > 0.0 ? "" : "-";
    const ImplicitSurface surface = surface_of(sign + "(x^2 + y^2/2 + x*y/4 + z^2 - 1)", 3.0);
    Random random(19);
    for (int i = 0; i < 500; ++i) {
      const ObjectRay ray = ray_of({}, DVec3(random.direction()));
      const auto crossing = surface.intersect(ray);
      ASSERT_TRUE(crossing.has_value());
      const ShapePoint point = surface.point(ray.at(crossing->t), *crossing);
      EXPECT_NEAR(point.uv.y, (3.0 - point.position.y) / 6.0, 1e-12);
      EXPECT_GT(dot(cross(point.dp_dv, point.dp_du), point.normal), 0.0);
      // A small step along either derivative, back on the surface, changes that coordinate alone.
      const double step = 1e-6;
      const DVec3 next_u = point.position + step * point.dp_du;
      const DVec3 next_v = point.position + step * point.dp_dv;
      const double scale = 1.0 + length(point.dp_dv) + length(point.dp_du);
      const ShapePoint right = cylindrical_point(next_u, point.normal, -3.0, 3.0);
      const ShapePoint down = cylindrical_point(next_v, point.normal, -3.0, 3.0);
      EXPECT_NEAR(right.uv.x - point.uv.x, step, 1e-10 * scale * scale);
      EXPECT_NEAR(right.uv.y - point.uv.y, 0.0, 1e-12);
      EXPECT_NEAR(down.uv.y - point.uv.y, step, 1e-12);
      EXPECT_NEAR(down.uv.x - point.uv.x, 0.0, 1e-10 * scale * scale);
      const double tangency = 1e-12 * scale;
      EXPECT_NEAR(dot(point.dp_du, point.normal), 0.0, tangency);
      EXPECT_NEAR(dot(point.dp_dv, point.normal), 0.0, tangency);
    }
  }
}

TEST(CylindricalPoint, FlatOrSingularPlaces_StillHaveAFrame) {
  const DVec3 p(1.0, 2.0, 0.5);
  for (const DVec3& gradient : {DVec3(0.0, 5.0, 0.0), DVec3(0.0, -1e-200, 0.0),
                                DVec3(0.5, 0.0, -1.0), DVec3(1e200, 1e200, -2e200), DVec3(0.0),
                                DVec3(k_nan, 1.0, 1.0), DVec3(k_infinity, 0.0, 0.0)}) {
    const ShapePoint point = cylindrical_point(p, gradient, -k_infinity, k_infinity);
    EXPECT_NEAR(length(point.normal), 1.0, 1e-12);
    EXPECT_EQ(point.uv.y, -2.0);
    EXPECT_GT(dot(cross(point.dp_dv, point.dp_du), point.normal), 0.0);
    EXPECT_NEAR(dot(point.dp_du, point.normal), 0.0, 1e-5);
    EXPECT_NEAR(dot(point.dp_dv, point.normal), 0.0, 1e-5);
  }
}

}  // namespace
}  // namespace lume::geometry
