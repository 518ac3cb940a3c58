// SPDX-License-Identifier: Apache-2.0
// Builders that cut triangles at planes rely on losing nothing of them.
#include "geometry/accelerators/clip_triangle.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lume::geometry {
namespace {

using test::Random;
using Corners = std::array<Vec3, 3>;

struct Case {
  Corners corners{};
  Bounds box;
  double size = 1.0;  ///< of the largest coordinates
};

/// Of all sizes and anywhere, and every other one on whole numbers: along the box's sides, edges
/// and corners.
Case random_case(Random& random) {
  const float scale = std::exp2(std::round(random.uniform(-80.0f, 80.0f)));
  const Vec3 offset = random.below(4) == 0 ? glm::round(random.cube(1e4f)) : Vec3(0.0f);
  const bool whole = random.below(2) == 0;
  const auto point = [&] {
    const Vec3 p = random.cube(3.5f);
    return scale * (offset + (whole ? glm::round(p) : p));
  };
  Case result;
  for (Vec3& corner : result.corners) corner = point();
  result.box.add(point());
  result.box.add(point());
  result.size = static_cast<double>(scale) * (3.5 + static_cast<double>(length(offset)));
  return result;
}

TEST(ClipTriangle, PointsOfTheTriangleInTheBox_AreInTheResult) {
  Random random(1);
  int inside = 0;
  for (int i = 0; i < test::cases(50000); ++i) {
    const auto [corners, box, size] = random_case(random);
    const Bounds result = clip_triangle(corners, box);
    for (int k = 0; k < 20; ++k) {
      auto u = static_cast<double>(random.uniform());
      auto v = static_cast<double>(random.uniform());
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      if (k % 4 == 0) v = 0.0;            // on an edge
      if (k % 4 == 1) v = 1.0 - u;        // on another
      if (k < 3) u = k == 1, v = k == 2;  // a corner
      const DVec3 p =
          (1.0 - u - v) * DVec3(corners[0]) + u * DVec3(corners[1]) + v * DVec3(corners[2]);
      const auto is_in = [&p](const Bounds& bounds) {
        return DBounds{DVec3(bounds.lower), DVec3(bounds.upper)}.contains(p);
      };
      if (!is_in(box)) continue;
      ++inside;
      EXPECT_TRUE(is_in(result)) << "case " << i;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(inside, test::cases(50000));
}

/// Around all corners of the part in the box: corners of the triangle, edges of the triangle in the
/// box's sides, and edges of the box in the triangle's plane. In long double, and a little too
/// wide.
class Corner {
 public:
  explicit Corner(const Case& c) : case_(c), tolerance_(1e-9L * static_cast<long double>(c.size)) {}

  BoundsOf<glm::tvec3<long double>> around_all() {
    for (int i = 0; i < 3; ++i) {
      const Point a(case_.corners[i]);
      const Point b(case_.corners[(i + 1) % 3]);
      add_if_in_box(a);
      for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {case_.box.lower[axis], case_.box.upper[axis]}) {
          if (a[axis] != b[axis])
            add_if_in_box(a + (side - a[axis]) / (b[axis] - a[axis]) * (b - a));
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (int edge = 0; edge < 4; ++edge) add_crossing(axis, edge);
    }
    return result_;
  }

 private:
  using Point = glm::tvec3<long double>;

  void add_if_in_box(const Point& p) {
    for (int i = 0; i < 3; ++i) {
      if (p[i] < case_.box.lower[i] - tolerance_ || p[i] > case_.box.upper[i] + tolerance_) return;
    }
    result_.add(p);
  }

  /// Where the box's edge along an axis meets the triangle.
  void add_crossing(int axis, int edge) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    Point p(0.0L);
    p[u] = (edge & 1) != 0 ? case_.box.upper[u] : case_.box.lower[u];
    p[v] = (edge & 2) != 0 ? case_.box.upper[v] : case_.box.lower[v];
    const Point a(case_.corners[0]);
    const Point b = Point(case_.corners[1]) - a;
    const Point c = Point(case_.corners[2]) - a;
    const long double area = b[u] * c[v] - b[v] * c[u];
    if (area == 0.0L) return;
    const long double s = ((p[u] - a[u]) * c[v] - (p[v] - a[v]) * c[u]) / area;
    const long double t = (b[u] * (p[v] - a[v]) - b[v] * (p[u] - a[u])) / area;
    if (s < -1e-9L || t < -1e-9L || s + t > 1.0L + 1e-9L) return;
    p[axis] = a[axis] + s * b[axis] + t * c[axis];
    add_if_in_box(p);
  }

  const Case& case_;
  long double tolerance_;
  BoundsOf<Point> result_;
};

TEST(ClipTriangle, Result_IsNoLargerThanThePartInTheBox) {
  Random random(2);
  int cut = 0;
  for (int i = 0; i < test::cases(50000); ++i) {
    const Case c = random_case(random);
    const Bounds result = clip_triangle(c.corners, c.box);
    if (result.is_empty()) continue;
    ++cut;
    const auto expected = Corner(c).around_all();
    const long double tolerance = 3e-7L * static_cast<long double>(c.size);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(result.lower[axis], result.upper[axis]) << "case " << i;
      EXPECT_GE(result.lower[axis], c.box.lower[axis]) << "case " << i;
      EXPECT_LE(result.upper[axis], c.box.upper[axis]) << "case " << i;
      EXPECT_GE(result.lower[axis], expected.lower[axis] - tolerance) << "case " << i;
      EXPECT_LE(result.upper[axis], expected.upper[axis] + tolerance) << "case " << i;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(cut, test::cases(5000));
}

TEST(ClipTriangle, EdgeThroughTheBoxsEdge_IsNotRoundedAway) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    // From a to b through (0, 0, z): a crossing that double can only round, on the edge of the box.
    const auto number = [&random] { return static_cast<float>(1 + random.below(1000)); };
    const float slope = (random.below(2) == 0 ? 1.0f : -1.0f) * number();
    const float before = number();
    const float behind = number();
    const Vec3 a(-before, -before * slope, -1.0f);
    const Vec3 b(behind, behind * slope, 1.0f);
    const Vec3 c(-behind, behind * slope, 1.0f);  // the triangle is beyond the box but for the edge
    const Bounds box{Vec3(0.0f, slope > 0.0f ? -2e6f : 0.0f, -2.0f),
                     Vec3(2e3f, slope > 0.0f ? 0.0f : 2e6f, 2.0f)};
    const Bounds result = clip_triangle({a, b, c}, box);
    ASSERT_FALSE(result.is_empty()) << i;
    EXPECT_EQ(result.lower.x, 0.0f) << i;
    EXPECT_TRUE(result.lower.y <= 0.0f && result.upper.y >= 0.0f) << i;
  }
}

TEST(ClipTriangle, TriangleBesideTheBox_LeavesNothing) {
  const Bounds box{Vec3(0.0f), Vec3(1.0f)};
  EXPECT_TRUE(clip_triangle({Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(2, 1, 0)}, box).is_empty());
  // Its box overlaps the other, but it runs past a corner.
  EXPECT_TRUE(clip_triangle({Vec3(0.9f, 2, 0), Vec3(2, 0.9f, 0), Vec3(2, 2, 0)}, box).is_empty());
  EXPECT_TRUE(clip_triangle({Vec3(0), Vec3(1), Vec3(0, 1, 0)}, Bounds()).is_empty());
}

TEST(ClipTriangle, HalfOfASquare_IsCutToItsQuarter) {
  const Corners corners{Vec3(0, 0, 5), Vec3(4, 0, 5), Vec3(0, 4, 5)};
  const Bounds result = clip_triangle(corners, {Vec3(1, 1, 0), Vec3(9, 2, 9)});
  EXPECT_EQ(result.lower.x, 1.0f);
  EXPECT_NEAR(result.upper.x, 3.0f, 1e-6f);
  EXPECT_EQ(result.lower.y, 1.0f);
  EXPECT_EQ(result.upper.y, 2.0f);
  EXPECT_NEAR(result.lower.z, 5.0f, 1e-6f);
  EXPECT_NEAR(result.upper.z, 5.0f, 1e-6f);
}

}  // namespace
}  // namespace lume::geometry
