// SPDX-License-Identifier: Apache-2.0
// The shapes with a closed form against oracles in higher precision: 100,000 rays each, among them
// those on which formulas fail.
#include "geometry/shapes/shape.h"
#include "tests/geometry/shapes/referee.h"
#include "tests/geometry/shapes/shape_cases.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace lume::geometry {
namespace {

class ClosedForm : public testing::TestWithParam<ShapeCase> {
 protected:
  /// What there is to be seen of the shape: crossings of random rays.
  std::vector<ShapePoint> sample_surface(Random& random, int rays) const {
    std::vector<ShapePoint> points;
    for (int i = 0; i < rays; ++i) {
      ObjectRay ray{size() * DVec3(random.cube(2.0f)), {}};
      ray.direction = size() * DVec3(random.cube(1.0f)) - ray.origin;
      if (const auto crossing = intersect(shape(), ray)) {
        points.push_back(shape_point(shape(), ray, *crossing));
      }
    }
    return points;
  }
  [[nodiscard]] const Shape& shape() const { return GetParam().shape; }
  [[nodiscard]] double size() const { return GetParam().size; }
};

TEST_P(ClosedForm, RandomAndHardRays_MatchTheOracle) {
  Random random(7);
  const std::vector<ShapePoint> surface = sample_surface(random, 2000);
  ASSERT_GT(surface.size(), 100u);
  constexpr int k_rays = 100000;
  std::array<int, 5> hits{};
  std::array<int, 5> marginal{};
  for (int i = 0; i < k_rays; ++i) {
    const int kind = i % GetParam().ray_kinds;
    const auto on_surface = surface[random.below(static_cast<std::uint32_t>(surface.size()))];
    ObjectRay ray = make_ray(random, size(), on_surface, kind);
    if (kind == 3) ray.t_min = 1e-9 * size() / length(ray.direction);
    if (random.uniform() < 0.2f)
      ray.t_max = random.uniform(0.0f, 4.0f) * size() / length(ray.direction);
    const auto answer = intersect(shape(), ray);
    const Verdict verdict = Referee(GetParam(), ray).judge(answer);
    ASSERT_NE(verdict, Verdict::wrong)
        << "ray " << i << " of kind " << kind << (answer ? ", met at " : ", missed ")
        << (answer ? answer->t : 0.0);
    EXPECT_EQ(meets(shape(), ray), answer.has_value());
    hits[static_cast<std::size_t>(kind)] += answer ? 1 : 0;
    marginal[static_cast<std::size_t>(kind)] += verdict == Verdict::marginal ? 1 : 0;
  }
  for (std::size_t kind = 0; kind < 5; ++kind) {
    EXPECT_GT(hits[kind], kind < 3 ? 500 : -1) << kind;
    EXPECT_LE(marginal[kind], kind < 3 ? 20 : 200) << kind;
  }
}

TEST_P(ClosedForm, ContinuingBehindACrossing_FindsTheNext) {
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    ObjectRay ray = make_ray(random, size(), {}, 0);
    auto expected = GetParam().oracle(RealRay(ray), 0.0);
    std::sort(expected.begin(), expected.end(),
              [](const auto& a, const auto& b) { return a.t < b.t; });
    for (const OracleCrossing& crossing : expected) {
      if (crossing.t < 0) continue;
      const auto answer = intersect(shape(), ray);
      ASSERT_TRUE(answer.has_value()) << "ray " << i;
      ASSERT_NEAR(answer->t, static_cast<double>(crossing.t), 1e-6) << "ray " << i;
      ray.t_min = std::nextafter(answer->t, std::numeric_limits<double>::infinity());
    }
    ASSERT_FALSE(intersect(shape(), ray).has_value()) << "ray " << i;
  }
}

TEST_P(ClosedForm, Points_LieOnTheSurfaceWithTangentsAcrossTheNormal) {
  Random random(9);
  for (int i = 0; i < 5000; ++i) {
    const ObjectRay ray = make_ray(random, size(), {}, i % 2);
    const auto crossing = intersect(shape(), ray);
    if (!crossing) continue;
    const ShapePoint point = shape_point(shape(), ray, *crossing);
    ASSERT_LT(length(point.position - ray.at(crossing->t)), 1e-8 * size());
    const DVec3 n = normalize(point.normal);
    ASSERT_LT(std::abs(dot(n, point.dp_du)), 1e-6 * length(point.dp_du) + 1e-12 * size());
    ASSERT_LT(std::abs(dot(n, point.dp_dv)), 1e-6 * length(point.dp_dv) + 1e-12 * size());
    const DVec3 area = cross(point.dp_dv, point.dp_du);
    if (length(area) < 1e-6 * size() * size()) continue;
    ASSERT_GT(dot(normalize(area), n), 0.999);
  }
}

/// A step along dp_du changes u, and nothing but u, by its length; the same for v.
TEST_P(ClosedForm, Tangents_AreTheDerivativesOfTheCoordinates) {
  if (!GetParam().has_coordinates) return;
  Random random(10);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    const ObjectRay ray = make_ray(random, size(), {}, 0);
    const auto crossing = intersect(shape(), ray);
    if (!crossing) continue;
    const auto at = [&](const DVec3& p) {
      return shape_point(shape(), {p, DVec3(0.0)}, {.t = 0.0, .part = crossing->part});
    };
    const ShapePoint point = shape_point(shape(), ray, *crossing);
    const DVec3 n = normalize(point.normal);
    // Texture coordinates jump at the seam, and are at their wits' end at poles, on the rim where
    // the front turns to the axis, and at apexes.
    const bool near_axis = length(DVec3(point.position.x, 0.0, point.position.z)) < 0.1 * size();
    if (near_axis || std::abs(dot(n, outwards(point.position))) < 0.05 || point.uv.x < 0.01 ||
        point.uv.x > 0.99) {
      const bool is_flat =
          length(cross(n, at(point.position + 0.1 * size() * point.dp_du).normal)) == 0.0;
      if (!is_flat) continue;
    }
    constexpr double k_step = 1e-6;
    for (const bool is_u : {true, false}) {
      const DVec3 step = k_step * (is_u ? point.dp_du : point.dp_dv);
      const DVec2 change =
          (at(point.position + step).uv - at(point.position - step).uv) / (2.0 * k_step);
      ASSERT_NEAR(change.x, is_u ? 1.0 : 0.0, 1e-4) << "ray " << i;
      ASSERT_NEAR(change.y, is_u ? 0.0 : 1.0, 1e-4) << "ray " << i;
    }
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

TEST_P(ClosedForm, Bounds_HoldAllOfItAndNoMore) {
  Random random(11);
  const std::vector<ShapePoint> surface = sample_surface(random, 50000);
  for (int round = 0; round < 20; ++round) {
    // Along the axes first, then any way.
    DVec3 direction(0.0);
    if (round < 6) {
      direction[round / 2] = round % 2 == 0 ? 1.0 : -1.0;
    } else {
      direction = DVec3(random.direction());
    }
    const double support = std::visit([&](const auto& s) { return s.support(direction); }, shape());
    double reached = -std::numeric_limits<double>::infinity();
    for (const ShapePoint& point : surface) {
      reached = std::max(reached, dot(point.position, direction));
    }
    ASSERT_LE(reached, support + 1e-12 * size()) << "round " << round;
    if (round < 6 && GetParam().is_bounded) {
      ASSERT_GT(reached, support - 0.06 * size()) << "round " << round;
    }
  }
}

TEST_P(ClosedForm, RaysThatAreNotFinite_MeetNothing) {
  constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
  for (const DVec3& bad : {DVec3(k_nan), DVec3(0.1, k_nan, 0.1), DVec3(0.1, 0.1, k_nan)}) {
    EXPECT_FALSE(intersect(shape(), {.origin = bad, .direction = {0.1, -1.0, 0.2}}).has_value());
    EXPECT_FALSE(intersect(shape(), {.origin = {0.1, 1.0, 0.1}, .direction = bad}).has_value());
  }
  const ObjectRay still{.origin = {0.1, 0.2, 0.3}, .direction = DVec3(0.0)};
  EXPECT_FALSE(intersect(shape(), still).has_value());
}

TEST(Quadric, CoefficientsThatAreNotNumbers_AreMetNowhere) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const bool caps : {false, true}) {
      const Quadric quadric(DMat4(bad), DVec3(-1.0), DVec3(1.0), caps);
      EXPECT_FALSE(quadric.intersect({{0.1, 3.0, 0.2}, {0.1, -1.0, 0.3}}).has_value());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosedForm, testing::ValuesIn(closed_form_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace lume::geometry
