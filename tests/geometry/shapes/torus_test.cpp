// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/torus.h"

#include "tests/geometry/shapes/surface_checks.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lume::geometry {
namespace {

using test::angle_between;
using test::Random;
using Real = long double;

/// The first point of a ray on the torus, without any polynomial: the distance from the surface,
/// |(q - R, y)| - r, changes by at most 1 for each metre of the ray, so a stretch whose ends are
/// farther from the surface than it is long holds no root; others are cut in two.
class Oracle {
 public:
  Oracle(const Torus& torus, const ObjectRay& ray) : torus_(torus), ray_(ray) {
    const Real size = static_cast<Real>(torus.major_radius) + torus.minor_radius;
    Real dd = 0;
    Real od = 0;
    for (int i = 0; i < 3; ++i) {
      dd += static_cast<Real>(ray.direction[i]) * ray.direction[i];
      od += static_cast<Real>(ray.origin[i]) * ray.direction[i];
    }
    speed_ = std::sqrt(dd);
    margin_ = 1e-12L * size;
    const Real begin = std::max<Real>(ray.t_min, -od / dd - 1.01L * size / speed_);
    const Real end = std::min<Real>(ray.t_max, -od / dd + 1.01L * size / speed_);
    if (begin < end) search(begin, distance(begin), end, distance(end));
    // What comes close just before it crosses is no tangent.
    if (hit && grazes && (t - touch_) * speed_ < 1e4L * margin_) grazes = false;
  }

  bool hit = false;
  bool grazes = false;  ///< comes within the margin before it hits, without a change of sign
  Real t = 0;

 private:
  [[nodiscard]] Real distance(Real at) const {
    const Real x = ray_.origin.x + at * ray_.direction.x;
    const Real y = ray_.origin.y + at * ray_.direction.y;
    const Real z = ray_.origin.z + at * ray_.direction.z;
    return std::hypot(std::sqrt(x * x + z * z) - torus_.major_radius, y) - torus_.minor_radius;
  }

  void search(Real begin, Real at_begin, Real end, Real at_end) {
    const Real extent = (end - begin) * speed_;
    const bool changes_sign = (at_begin < 0) != (at_end < 0);
    if (!changes_sign && std::abs(at_begin) + std::abs(at_end) > extent) return;
    const Real middle = (begin + end) / 2;
    if (extent < margin_) {
      if (!changes_sign && !grazes) touch_ = middle;
      (changes_sign ? hit : grazes) = true;
      if (changes_sign) t = middle;
      return;
    }
    const Real at_middle = distance(middle);
    search(begin, at_begin, middle, at_middle);
    if (!hit) search(middle, at_middle, end, at_end);
  }

  const Torus& torus_;
  const ObjectRay& ray_;
  Real speed_ = 0;
  Real margin_ = 0;
  Real touch_ = 0;
};

/// The gradient of the distance function, by hand.
DVec3 expected_normal(const Torus& torus, const DVec3& p) {
  const double q = std::hypot(p.x, p.z);
  const double aside = q - torus.major_radius;
  return normalize(DVec3(aside * p.x / q, p.y, aside * p.z / q));
}

Torus random_torus(Random& random) {
  const double major = std::pow(10.0, random.uniform(-3.0f, 6.0f));
  const double ratio = random.below(8) == 0 ? 1.0 : std::pow(10.0, random.uniform(-2.0f, 0.0f));
  return {major, ratio * major};
}

struct Tally {
  int hits = 0;
  int misses = 0;
  int grazing = 0;  ///< told apart, because the oracle itself came within 1e-12 of a tangent
};

void compare(const Torus& torus, const ObjectRay& ray, Tally& tally) {
  const Oracle oracle(torus, ray);
  const auto crossing = torus.intersect(ray);
  if (oracle.grazes) {
    ++tally.grazing;
    return;
  }
  ASSERT_EQ(crossing.has_value(), oracle.hit);
  ++(oracle.hit ? tally.hits : tally.misses);
  if (!oracle.hit) return;
  ASSERT_TRUE(ray.contains(crossing->t));
  const auto t = static_cast<double>(oracle.t);
  ASSERT_LE(std::abs(crossing->t - t), 1e-5 * std::abs(t));
  const DVec3 exact(static_cast<double>(ray.origin.x + oracle.t * ray.direction.x),
                    static_cast<double>(ray.origin.y + oracle.t * ray.direction.y),
                    static_cast<double>(ray.origin.z + oracle.t * ray.direction.z));
  const ShapePoint point = torus.point(ray.at(crossing->t), *crossing);
  const double size = torus.major_radius + torus.minor_radius;
  if (std::hypot(exact.x, exact.z) < 1e-6 * size) return;  // the cusp of the horn torus
  ASSERT_LT(angle_between(point.normal, expected_normal(torus, exact)), 1e-4);
}

TEST(Torus, RandomRays_AgreeWithExtendedPrecision) {
  Random random(1);
  Tally tally;
  for (int i = 0; i < 100000; ++i) {
    const Torus torus = random_torus(random);
    const double size = torus.major_radius + torus.minor_radius;
    ObjectRay ray;
    ray.origin = size * DVec3(random.cube(random.below(2) == 0 ? 1.0f : 4.0f));
    ray.direction = size * DVec3(random.cube(0.9f)) - ray.origin;
    ASSERT_NO_FATAL_FAILURE(compare(torus, ray, tally)) << "case " << i;
  }
  EXPECT_GT(tally.hits, 20000);
  EXPECT_GT(tally.misses, 20000);
  RecordProperty("grazing", tally.grazing);
  EXPECT_LE(tally.grazing, 5);
}

TEST(Torus, RaysFromFarAway_AgreeWithExtendedPrecision) {
  Random random(2);
  Tally tally;
  for (int i = 0; i < 10000; ++i) {
    const Torus torus = random_torus(random);
    const double size = torus.major_radius + torus.minor_radius;
    ObjectRay ray;
    ray.origin = 1e6 * size * DVec3(random.direction());
    ray.direction = (size * DVec3(random.cube(0.9f)) - ray.origin) * 1e-3;
    ASSERT_NO_FATAL_FAILURE(compare(torus, ray, tally)) << "case " << i;
  }
  EXPECT_GT(tally.hits, 2000);
  EXPECT_LE(tally.grazing, 5);
}

TEST(Torus, RaysBesideTangents_HitExactlyIfTheyPassInside) {
  // Parallel to the axis y and beside the outermost circle; level with the topmost circle.
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Torus torus{0.375, 0.125};
    const double gap = std::pow(10.0, random.uniform(-11.0f, -2.0f));
    const double turn = random.uniform(0.0f, 6.0f);
    const DVec3 out(std::cos(turn), 0.0, std::sin(turn));
    const DVec3 up(0.0, 1.0, 0.0);
    EXPECT_TRUE(torus.intersect({(0.5 - gap) * out + 3.0 * up, -up}));
    EXPECT_FALSE(torus.intersect({(0.5 + gap) * out + 3.0 * up, -up}));
    EXPECT_TRUE(torus.intersect({3.0 * out + (0.125 - gap) * up, -out}));
    EXPECT_FALSE(torus.intersect({3.0 * out + (0.125 + gap) * up, -out}));
    // Through the hole.
    EXPECT_TRUE(torus.intersect({(0.25 + gap) * out + 3.0 * up, -up}));
    EXPECT_FALSE(torus.intersect({(0.25 - gap) * out + 3.0 * up, -up}));
  }
  EXPECT_FALSE(Torus{}.intersect({DVec3(0.0, 3.0, 0.0), DVec3(0.0, -1.0, 0.0)}));
}

TEST(Torus, StartOnTheSurface_FindsItOrTheNextCrossing) {
  Random random(4);
  int onward = 0;
  for (int i = 0; i < 6000; ++i) {
    const Torus torus = random_torus(random);
    const double size = torus.major_radius + torus.minor_radius;
    const DVec3 near = size * DVec3(random.cube(0.9f));
    const ShapePoint start = torus.point(near, {});
    const DVec3 direction(random.direction());
    const ObjectRay at_once{start.position, direction};
    ObjectRay later = at_once;
    later.t_min = 1e-7 * torus.minor_radius;
    const Oracle oracle(torus, later);
    const bool leaves = std::abs(dot(direction, start.normal)) > 1e-3;
    if (!leaves || oracle.grazes) continue;
    const auto crossing = torus.intersect(later);
    ASSERT_EQ(crossing.has_value(), oracle.hit) << "case " << i;
    if (crossing) {
      ++onward;
      ASSERT_NEAR(crossing->t, static_cast<double>(oracle.t), 1e-9 * size) << "case " << i;
    }
    // Without the gap the start itself counts, if rounding has not put it behind the ray.
    const auto first = torus.intersect(at_once);
    if (first && first->t < 1e-11 * size) continue;
    ASSERT_EQ(first.has_value(), oracle.hit) << "case " << i;
  }
  EXPECT_GT(onward, 2000);
}

TEST(Torus, Interval_LimitsTheCrossings) {
  const Torus torus{1.0, 0.25};
  ObjectRay ray{DVec3(-3.0, 0.0, 0.0), DVec3(2.0, 0.0, 0.0)};
  for (const double expected : {0.875, 1.125, 1.875, 2.125}) {
    const auto crossing = torus.intersect(ray);
    ASSERT_TRUE(crossing);
    EXPECT_NEAR(crossing->t, expected, 1e-14);
    ray.t_max = expected - 1e-9;
    EXPECT_FALSE(torus.intersect(ray));
    ray.t_min = expected + 1e-9;
    ray.t_max = std::numeric_limits<double>::infinity();
  }
  EXPECT_FALSE(torus.intersect(ray));
}

TEST(Torus, Point_LiesOnTheSurfaceWithTrueDerivatives) {
  Random random(5);
  const auto position = [](const Torus& torus, const DVec2& uv) {
    // The parametrisation as the header describes it.
    const double turn = 2.0 * std::numbers::pi * (uv.x - 0.5);
    const double angle = 2.0 * std::numbers::pi * uv.y;
    const double ring = torus.major_radius + torus.minor_radius * std::sin(angle);
    return DVec3(ring * std::sin(turn), torus.minor_radius * std::cos(angle),
                 ring * std::cos(turn));
  };
  for (int i = 0; i < 20000; ++i) {
    const Torus torus = random_torus(random);
    const double size = torus.major_radius + torus.minor_radius;
    const ShapePoint point = torus.point(size * DVec3(random.cube(1.0f)), {});
    ASSERT_LT(length(point.position - position(torus, point.uv)), 1e-14 * size);
    const double h = 1e-5;
    const DVec3 du =
        (position(torus, point.uv + DVec2(h, 0.0)) - position(torus, point.uv - DVec2(h, 0.0))) /
        (2.0 * h);
    const DVec3 dv =
        (position(torus, point.uv + DVec2(0.0, h)) - position(torus, point.uv - DVec2(0.0, h))) /
        (2.0 * h);
    ASSERT_LT(length(point.dp_du - du), 1e-7 * size);
    ASSERT_LT(length(point.dp_dv - dv), 1e-7 * size);
    if (length(point.dp_du) < 1e-6 * size) continue;
    ASSERT_LT(angle_between(cross(point.dp_dv, point.dp_du), point.normal), 1e-9);
  }
}

TEST(Torus, Support_IsReachedAndNeverExceeded) {
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Torus torus = random_torus(random);
    const double size = torus.major_radius + torus.minor_radius;
    const DVec3 direction(random.direction());
    const double support = torus.support(direction);
    double most = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const ShapePoint point = torus.point(size * DVec3(random.cube(1.0f)), {});
      most = std::max(most, dot(point.position, direction));
    }
    ASSERT_LE(most, support + 1e-14 * size);
    ASSERT_GT(most, support - 0.1 * size);
  }
}

TEST(Torus, RaysThatAreNone_HitNothing) { test::expect_that_broken_rays_hit_nothing(Torus{}); }

}  // namespace
}  // namespace lume::geometry
