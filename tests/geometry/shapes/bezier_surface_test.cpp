// SPDX-License-Identifier: Apache-2.0
// Rays by the thousands against an oracle, and against cracks.
#include "geometry/shapes/bezier_surface.h"

#include "tests/geometry/shapes/bezier_oracle.h"
#include "tests/geometry/shapes/bezier_patches.h"
#include "tests/geometry/shapes/surface_checks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

using test::angle_between;
using test::BezierOracle;
using test::closed_surface;
using test::Random;
using test::random_patch;

/// Whether surface and oracle say the same of a ray.
testing::AssertionResult agree(const BezierSurface& surface, const ObjectRay& ray,
                               const BezierOracle& oracle) {
  const auto crossing = surface.intersect(ray);
  if (crossing.has_value() != oracle.hit) {
    return testing::AssertionFailure() << (oracle.hit ? "a miss" : "a false hit");
  }
  if (!crossing) return testing::AssertionSuccess();
  const auto t = static_cast<double>(oracle.t);
  const double error = std::abs(crossing->t - t) / std::abs(t);
  const ShapePoint point = surface.point(ray.at(crossing->t), *crossing);
  const double angle = angle_between(point.normal, oracle.normal);
  if (ray.contains(crossing->t) && error <= 1e-5 && angle <= 1e-4) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure()
         << "t " << crossing->t << " not " << t << ", normal " << angle << " rad apart";
}

struct Tally {
  int hits = 0;
  int misses = 0;
  int looked_at_twice = 0;  ///< where 2^-20 of a patch were too coarse for the oracle
};

void compare(const BezierSurface& surface, const ObjectRay& ray, Tally& tally) {
  const BezierOracle oracle(surface.patches(), ray, 20);
  if (!agree(surface, ray, oracle)) {
    ++tally.looked_at_twice;
    const BezierOracle finer(surface.patches(), ray, 40);
    ASSERT_TRUE(agree(surface, ray, finer));
    return;
  }
  ++(oracle.hit ? tally.hits : tally.misses);
  ASSERT_EQ(surface.meets(ray), oracle.hit);
}

TEST(BezierSurface, RandomRays_AgreeWithExtendedPrecision) {
  Random random(1);
  Tally tally;
  for (int i = 0; i < 250; ++i) {
    const double scale = std::pow(10.0, random.uniform(-3.0f, 6.0f));
    const DVec3 middle = scale * DVec3(random.cube(3.0f));
    std::vector<BezierPatch> patches{random_patch(random, random.uniform(0.0f, 0.5f)),
                                     random_patch(random, random.uniform(0.0f, 0.3f))};
    for (BezierPatch& patch : patches) {
      for (DVec3& p : patch) p = middle + scale * p;
    }
    const BezierSurface surface(patches);
    for (int k = 0; k < 400; ++k) {
      ObjectRay ray;
      ray.origin = middle + scale * DVec3(random.cube(random.below(2) == 0 ? 0.7f : 3.0f));
      ray.direction = middle + scale * DVec3(random.cube(0.6f)) - ray.origin;
      ASSERT_NO_FATAL_FAILURE(compare(surface, ray, tally)) << "surface " << i << ", ray " << k;
    }
  }
  RecordProperty("hits", tally.hits);
  RecordProperty("looked_at_twice", tally.looked_at_twice);
  EXPECT_GT(tally.hits, 30000);
  EXPECT_GT(tally.misses, 20000);
  EXPECT_LE(tally.looked_at_twice, 500);
}

/// The point of a patch and the exit from the surface's inside through it.
ObjectRay ray_through(const BezierPatch& patch, const DVec2& uv, const DVec3& inside) {
  return {inside, evaluate(patch, uv.x, uv.y).position - inside};
}

TEST(BezierSurface, RaysAtSharedEdgesAndCorners_NeverSlipThrough) {
  Random random(2);
  int cases = 0;
  for (const double scale : {1.0, 1e-3, 1e6}) {
    for (const int n : {1, 2, 3}) {
      std::vector<BezierPatch> patches = closed_surface(n);
      const DVec3 middle = n == 3 ? scale * DVec3(20.0, -30.0, 10.0) : DVec3(0.0);
      for (BezierPatch& patch : patches) {
        for (DVec3& p : patch) p = middle + scale * p;
      }
      const BezierSurface surface(patches);
      for (int i = 0; i < 12000; ++i) {
        const BezierPatch& patch = patches[random.below(static_cast<unsigned>(patches.size()))];
        const double edge = random.below(2);
        // Every fourth at a corner, another at a point where sub-patches are likely to meet.
        double along = random.uniform();
        if (i % 4 == 0) along = random.below(2);
        if (i % 4 == 1) along = random.below(17) / 16.0;
        const DVec2 uv = i % 8 < 4 ? DVec2(edge, along) : DVec2(along, edge);
        ObjectRay ray = ray_through(patch, uv, middle + scale * DVec3(random.cube(0.2f)));
        const auto out = surface.intersect(ray);
        ASSERT_TRUE(out) << "n " << n << ", ray " << i;
        ASSERT_LE(out->t, 1.0 + 1e-9);
        // And in again, from outside through the same point.
        ray.origin += (i % 3 == 0 ? 1e3 : 4.0) * ray.direction;
        ray.direction = -ray.direction;
        ASSERT_TRUE(surface.meets(ray)) << "n " << n << ", ray " << i;
        ++cases;
      }
    }
  }
  EXPECT_GE(cases, 100000);
}

TEST(BezierSurface, ClosedSurface_IsCrossedAnOddNumberOfTimesFromInside) {
  Random random(3);
  const BezierSurface surface(closed_surface(2));
  for (int i = 0; i < 5000; ++i) {
    ObjectRay ray{DVec3(random.cube(0.2f)), DVec3(random.direction())};
    int crossings = 0;
    for (auto hit = surface.intersect(ray); hit; hit = surface.intersect(ray)) {
      ++crossings;
      ray.t_min = hit->t + 1e-7;
    }
    ASSERT_EQ(crossings % 2, 1) << "ray " << i;
  }
}

TEST(BezierSurface, RaysFromFarAway_FindTheSamePoint) {
  Random random(4);
  const BezierSurface surface({random_patch(random, 0.3f), random_patch(random, 0.3f)});
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const DVec3 target(random.cube(0.5f));
    const DVec3 direction(random.direction());
    const ObjectRay ray{target - 1e6 * direction, direction};
    const BezierOracle oracle(surface.patches(), ray, 1);
    const auto crossing = surface.intersect(ray);
    if (!oracle.hit) {
      ASSERT_FALSE(crossing);
    }
    if (!crossing) continue;
    ++hits;
    // A double's last place at 1e6 is 1e-10.
    const DVec3 point = surface.point(ray.at(crossing->t), *crossing).position;
    ASSERT_LT(length(cross(point - ray.origin, ray.direction)), 1e-9);
    ASSERT_LT(length(point - ray.at(crossing->t)), 1e-9);
  }
  EXPECT_GT(hits, 3000);
}

TEST(BezierSurface, FarAndNear_AgreeWithExtendedPrecision) {
  Random random(5);
  Tally tally;
  for (int i = 0; i < 3000; ++i) {
    static const BezierSurface surface({random_patch(random, 0.4f)});
    const DVec3 direction(random.direction());
    const double distance = std::pow(10.0, random.uniform(0.0f, 6.0f));
    const double speed = std::pow(10.0, random.uniform(-6.0f, 6.0f));
    const ObjectRay ray{DVec3(random.cube(0.5f)) - distance * direction, speed * direction};
    ASSERT_NO_FATAL_FAILURE(compare(surface, ray, tally)) << "ray " << i;
  }
  EXPECT_GT(tally.hits, 1000);
  EXPECT_LE(tally.looked_at_twice, 60);
}

TEST(BezierSurface, StartOnTheSurface_FindsItOrTheNextCrossing) {
  Random random(6);
  Tally tally;
  const BezierSurface surface(closed_surface(1));
  for (int i = 0; i < 3000; ++i) {
    const BezierPatch& patch = surface.patches()[random.below(6)];
    const double u = random.uniform();
    const double v = random.uniform();
    ObjectRay ray{evaluate(patch, u, v).position, DVec3(random.direction())};
    const auto at_once = surface.intersect(ray);
    ray.t_min = 0.01;
    ASSERT_NO_FATAL_FAILURE(compare(surface, ray, tally)) << "ray " << i;
    const auto later = surface.intersect(ray);
    if (!at_once) {
      ASSERT_FALSE(later) << "ray " << i;
    } else if (at_once->t > ray.t_min) {
      ASSERT_TRUE(later && later->t == at_once->t) << "ray " << i;
    }
  }
  EXPECT_GT(tally.hits, 1000);
  EXPECT_LE(tally.looked_at_twice, 300);
}

}  // namespace
}  // namespace lume::geometry
