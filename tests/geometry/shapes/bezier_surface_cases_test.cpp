// SPDX-License-Identifier: Apache-2.0
// The hard cases: silhouettes, rulings, poles, flat and degenerate patches, extreme scales; and
// what is known of a point.
#include "geometry/shapes/bezier_surface.h"

#include "tests/geometry/shapes/bezier_patches.h"
#include "tests/geometry/shapes/surface_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::geometry {
namespace {

using test::angle_between;
using test::arch;
using test::closed_surface;
using test::flat_patch;
using test::Random;
using test::random_patch;

TEST(BezierSurface, RaysBesideASilhouette_HitExactlyIfTheyPassBelowIt) {
  Random random(7);
  const BezierSurface surface({arch(0.25)});
  for (int i = 0; i < 3000; ++i) {
    const double gap = std::pow(10.0, random.uniform(-13.0f, -2.0f));
    const double y = random.uniform(0.1f, 0.9f);
    const double slope = random.uniform(-0.02f, 0.02f);
    const DVec3 direction(1.0, slope, 0.0);
    const auto below = surface.intersect({DVec3(-2.0, y, 0.25 - gap), direction});
    ASSERT_TRUE(below) << gap;
    // 4 h u (1 - u) = h - gap
    ASSERT_NEAR(below->t, 2.5 - std::sqrt(gap), 1e-7) << gap;
    ASSERT_NEAR(below->u, 0.5 - std::sqrt(gap), 1e-7) << gap;
    ASSERT_FALSE(surface.intersect({DVec3(-2.0, y, 0.25 + gap), direction})) << gap;
  }
}

TEST(BezierSurface, RaysWithinARuling_EndInTime) {
  // Along the straight lines of the arch, within them and at angles down to rounding.
  Random random(8);
  const BezierSurface surface({arch(0.25)});
  for (int i = 0; i < 300; ++i) {
    const double u = random.uniform(0.1f, 0.9f);
    const double tilt = i % 2 == 0 ? 0.0 : std::pow(10.0, random.uniform(-16.0f, -2.0f));
    const DVec3 middle = evaluate(surface.patches()[0], u, 0.5).position;
    const DVec3 direction(0.0, 1.0, -tilt);
    const auto crossing = surface.intersect({middle - 2.0 * direction, direction});
    if (tilt < 1e-9) continue;
    ASSERT_TRUE(crossing) << tilt;
    ASSERT_NEAR(crossing->t, 2.0, 1e-14 / tilt);
  }
}

TEST(BezierSurface, FlatPatch_IsAParallelogram) {
  Random random(9);
  const BezierSurface surface({flat_patch()});
  for (int i = 0; i < 5000; ++i) {
    const DVec3 target(random.uniform(-0.5f, 1.5f), random.uniform(-0.5f, 1.5f), 0.0);
    DVec3 direction(random.direction());
    if (i % 2 == 0) direction.z *= std::pow(10.0, random.uniform(-9.0f, 0.0f));
    const ObjectRay ray{target - 3.0 * direction, direction};
    const bool is_inside = target.x >= 0.0 && target.x <= 1.0 && target.y >= 0.0 && target.y <= 1.0;
    const auto crossing = surface.intersect(ray);
    ASSERT_EQ(crossing.has_value(), is_inside) << "ray " << i;
    if (!crossing) continue;
    ASSERT_NEAR(crossing->u, target.x, 1e-5);
    ASSERT_NEAR(crossing->v, target.y, 1e-5);
  }
  // Edge-on, as it is for a plane.
  EXPECT_FALSE(surface.intersect({DVec3(-1.0, 0.3, 0.0), DVec3(1.0, 0.1, 0.0)}));
}

TEST(BezierSurface, CollapsedEdge_HasTheNormalOfItsLimit) {
  // An eighth of a ball-like cap: v = 0 is its pole (0, 0, 1).
  const double k = 0.5522847498;
  BezierPatch cap;
  const DVec2 profile[4] = {{0.0, 1.0}, {k, 1.0}, {1.0, k}, {1.0, 0.0}};
  const DVec2 quarter[4] = {{1.0, 0.0}, {1.0, k}, {k, 1.0}, {0.0, 1.0}};
  for (std::size_t i = 0; i < 16; ++i) {
    const DVec2 ring = profile[i / 4].x * quarter[i % 4];
    cap[i] = {ring.x, ring.y, profile[i / 4].y};
  }
  const BezierSurface surface({cap});
  const DVec3 inwards = surface.point({}, {.u = 0.5, .v = 0.5}).normal;
  const double side = inwards.z > 0.0 ? 1.0 : -1.0;
  for (const double u : {0.0, 0.3, 1.0}) {
    const ShapePoint pole = surface.point({}, {.u = u, .v = 0.0});
    EXPECT_EQ(length(pole.dp_du), 0.0);
    EXPECT_LT(angle_between(pole.normal, DVec3(0.0, 0.0, side)), 1e-4);
  }
  Random random(10);
  for (int i = 0; i < 2000; ++i) {
    // Rays down to the pole, from it to any distance.
    const double away = i % 10 == 0 ? 0.0 : std::pow(10.0, random.uniform(-15.0f, -1.0f));
    const double turn = random.uniform(0.05f, 1.5f);
    const DVec3 target(away * std::cos(turn), away * std::sin(turn), 0.0);
    const DVec3 direction(0.0, 0.0, -1.0);
    const auto crossing = surface.intersect({target - 3.0 * direction, direction});
    ASSERT_TRUE(crossing) << away;
    const ShapePoint point = surface.point({}, *crossing);
    ASSERT_LT(length(point.position - (target + DVec3(0.0, 0.0, point.position.z))), 1e-9);
    ASSERT_GT(dot(normalize(point.normal), DVec3(0.0, 0.0, side)), std::cos(1e-4 + 2.0 * away));
  }
}

TEST(BezierSurface, DegeneratePatches_AreNotMet) {
  BezierPatch point;
  point.fill(DVec3(0.25, 0.5, 0.0));
  BezierPatch line = flat_patch();
  for (DVec3& p : line) p.y = 0.5;
  for (const BezierPatch& patch : {point, line}) {
    const BezierSurface surface({patch});
    const ObjectRay through{DVec3(0.25, 0.5, 1.0), DVec3(0.0, 0.0, -1.0)};
    const ObjectRay along{DVec3(-1.0, 0.5, 0.0), DVec3(1.0, 0.0, 0.0)};
    EXPECT_FALSE(surface.intersect(through));
    EXPECT_FALSE(surface.intersect(along));
    const DVec3 normal = surface.point({}, {.u = 0.3, .v = 0.3}).normal;
    EXPECT_GT(length(normal), 0.0);
  }
  const BezierSurface nothing({});
  EXPECT_FALSE(nothing.meets({DVec3(0.0, 0.0, 1.0), DVec3(0.0, 0.0, -1.0)}));
}

TEST(BezierSurface, ExtremeScales_AreMetAlike) {
  Random random(11);
  const BezierPatch patch = random_patch(random, 0.3f);
  const BezierSurface unit({patch});
  for (const double scale : {0x1p-80, 0x1p-30, 0x1p30, 0x1p80}) {
    BezierPatch scaled = patch;
    for (DVec3& p : scaled) p *= scale;
    const BezierSurface surface({scaled});
    for (int i = 0; i < 500; ++i) {
      ObjectRay ray{DVec3(random.cube(2.0f)), DVec3(random.cube(1.0f))};
      const auto expected = unit.intersect(ray);
      ray.origin *= scale;
      ray.direction *= scale;
      const auto crossing = surface.intersect(ray);
      ASSERT_EQ(crossing.has_value(), expected.has_value());
      if (crossing) {
        ASSERT_DOUBLE_EQ(crossing->t, expected->t);
      }
    }
  }
}

TEST(BezierSurface, Point_HasTrueDerivatives) {
  Random random(12);
  for (int i = 0; i < 300; ++i) {
    const BezierSurface surface({flat_patch(), random_patch(random, 0.5f)});
    const double u = random.uniform(0.01f, 0.99f);
    const double v = random.uniform(0.01f, 0.99f);
    const auto position = [&](double s, double t) {
      return surface.point({}, {.u = s, .v = t, .part = 1}).position;
    };
    const double h = 1e-5;
    const ShapePoint point = surface.point({}, {.u = u, .v = v, .part = 1});
    const DVec3 du = (position(u + h, v) - position(u - h, v)) / (2.0 * h);
    const DVec3 dv = (position(u, v + h) - position(u, v - h)) / (2.0 * h);
    ASSERT_LT(length(point.dp_du - du), 1e-8);
    ASSERT_LT(length(point.dp_dv - dv), 1e-8);
    ASSERT_EQ(point.uv, DVec2(u, v));
    ASSERT_LT(angle_between(point.normal, cross(dv, du)), 1e-5);
  }
}

TEST(BezierSurface, Support_BoundsTheSurfaceTightly) {
  Random random(13);
  for (int i = 0; i < 30; ++i) {
    const BezierSurface surface({random_patch(random, 0.5f), random_patch(random, 0.5f)});
    const DVec3 direction(random.direction());
    double most = -std::numeric_limits<double>::infinity();
    for (const BezierPatch& patch : surface.patches()) {
      for (int k = 0; k <= 40; ++k) {
        for (int j = 0; j <= 40; ++j) {
          most = std::max(most, dot(evaluate(patch, k / 40.0, j / 40.0).position, direction));
        }
      }
    }
    ASSERT_GE(surface.support(direction), most);
    ASSERT_LE(surface.support(direction), most + 0.01);
    ASSERT_NEAR(surface.support(3.0 * direction), 3.0 * surface.support(direction), 1e-12);
  }
}

TEST(BezierSurface, Interval_LimitsTheCrossings) {
  const BezierSurface surface({flat_patch()});
  ObjectRay ray{DVec3(0.3, 0.4, 2.0), DVec3(0.0, 0.0, -1.0)};
  EXPECT_TRUE(surface.meets(ray));
  ray.t_max = 1.999;
  EXPECT_FALSE(surface.meets(ray));
  ray.t_max = 3.0;
  ray.t_min = 2.001;
  EXPECT_FALSE(surface.meets(ray));
  ray.t_min = 1.5;
  EXPECT_TRUE(surface.meets(ray));
}

TEST(BezierSurface, RaysThatAreNone_HitNothing) {
  test::expect_that_broken_rays_hit_nothing(BezierSurface(closed_surface(1)));
}

}  // namespace
}  // namespace lume::geometry
