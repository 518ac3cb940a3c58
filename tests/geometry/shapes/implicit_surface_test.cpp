// SPDX-License-Identifier: Apache-2.0
// Rays against an oracle that knows nothing of intervals. The hard cases have a file of their own.
#include "tests/geometry/shapes/implicit_rays.h"
#include "tests/geometry/shapes/line_oracle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace lume::geometry {
namespace {

using test::all_crossings;
using test::any_ray;
using test::Polynomial;
using test::Random;
using test::Real;
using test::Roots;
using test::surface_of;

double angle_between(const DVec3& a, const DVec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

struct Counts {
  int hits = 0;
  int misses = 0;
  int open = 0;  // the oracle cannot tell: a tangent, or a crossing at the box's rim
};

/// Compares a ray's crossings with the oracle's. Those are given as distances from the ray's
/// origin.
template <class Gradient>
void compare(const ImplicitSurface& surface, double half_size, const ObjectRay& ray, Roots oracle,
             const Gradient& gradient, Counts& counts) {
  const Real speed = static_cast<Real>(length(ray.direction));
  std::vector<double> expected;
  for (const Real root : oracle.t) {
    const DVec3 p = ray.at(static_cast<double>(root / speed));
    const double outermost = std::fmax(std::abs(p.x), std::fmax(std::abs(p.y), std::abs(p.z)));
    if (std::abs(outermost - half_size) < 1e-8 * half_size || std::abs(root) < 1e-9L) {
      oracle.is_open = true;
    }
    if (outermost < half_size && root >= 0) expected.push_back(static_cast<double>(root / speed));
  }
  if (oracle.is_open) {
    ++counts.open;
    static_cast<void>(all_crossings(surface, ray));
    return;
  }
  ++(expected.empty() ? counts.misses : counts.hits);
  const std::vector<double> found = all_crossings(surface, ray);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_NEAR(found[i], expected[i], 1e-5 * expected[i]);
    const DVec3 near = ray.at(found[i]);
    const ShapePoint point = surface.point(near, {.t = found[i]});
    ASSERT_LT(angle_between(point.normal, gradient(ray.at(expected[i]))), 1e-4);
    ASSERT_LT(length(point.position - near), 1e-6 * half_size);
  }
}

template <class Formula>
void check_polynomial(const std::string& text, double half_size, int rays, const Formula& formula) {
  SCOPED_TRACE(text);
  const ImplicitSurface surface = surface_of(text, half_size);
  const auto gradient = [&](const DVec3& p) {
    DVec3 result(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      const auto variable = [&](int i) { return Polynomial(p[i], i == axis ? 1 : 0); };
      const Polynomial f = formula(variable(0), variable(1), variable(2));
      result[axis] = static_cast<double>(f.c[1]);
    }
    return result;
  };
  Random random(11);
  Counts counts;
  for (int i = 0; i < rays; ++i) {
    const ObjectRay ray = any_ray(random, half_size);
    // Expanded where the line is nearest to the middle, where the coefficients are smallest.
    Real d[3];
    Real middle = 0;
    const auto& o = ray.origin;
    const Real speed = std::sqrt(static_cast<Real>(ray.direction.x) * ray.direction.x +
                                 static_cast<Real>(ray.direction.y) * ray.direction.y +
                                 static_cast<Real>(ray.direction.z) * ray.direction.z);
    for (int axis = 0; axis < 3; ++axis) {
      d[axis] = static_cast<Real>(ray.direction[axis]) / speed;
      middle -= d[axis] * static_cast<Real>(o[axis]);
    }
    const auto along = [&](int axis) {
      return Polynomial(static_cast<Real>(o[axis]) + middle * d[axis], d[axis]);
    };
    const Real reach = 2 * static_cast<Real>(half_size);
    Roots roots = roots_of(formula(along(0), along(1), along(2)), -reach, reach, 1e-11L);
    for (Real& root : roots.t) root += middle;
    ASSERT_NO_FATAL_FAILURE(compare(surface, half_size, ray, roots, gradient, counts)) << i;
  }
  EXPECT_GT(counts.hits, rays / 10);
  EXPECT_GT(counts.misses, rays / 50);
  EXPECT_LT(counts.open, 2 + rays / 5000);
}

TEST(ImplicitSurface, Sphere_MatchesOracle) {
  check_polynomial("x^2 + y^2 + z^2 - 1", 1.5, 27000,
                   [](auto x, auto y, auto z) { return x * x + y * y + z * z - 1; });
}

TEST(ImplicitSurface, Torus_MatchesOracleOfItsQuartic) {
  const auto quartic = [](auto x, auto y, auto z) {
    const auto sum = x * x + y * y + z * z + Real{1} - Real{0.3} * Real{0.3};
    return sum * sum - Real{4} * (x * x + z * z);
  };
  // The 0.3 of the formula is the double nearest to it, and so is that of the oracle.
  check_polynomial("(x^2 + y^2 + z^2 + 1 - 0.3^2)^2 - 4*(x^2 + z^2)", 1.5, 10000, quartic);
}

TEST(ImplicitSurface, TorusWithRoot_MatchesOracleOfItsQuartic) {
  const ImplicitSurface surface = surface_of("(sqrt(x^2 + z^2) - 1)^2 + y^2 - 0.09", 1.5);
  Random random(12);
  Counts counts;
  const Real r2 = 0.09;
  const auto gradient = [](const DVec3& p) {
    const double ring = std::sqrt(p.x * p.x + p.z * p.z);
    return DVec3((ring - 1) * p.x / ring, p.y, (ring - 1) * p.z / ring);
  };
  for (int i = 0; i < 10000; ++i) {
    ObjectRay ray = any_ray(random, 1.5);
    ray.direction = normalize(ray.direction);
    const auto along = [&](int axis) { return Polynomial(ray.origin[axis], ray.direction[axis]); };
    const Polynomial x = along(0), y = along(1), z = along(2);
    const Polynomial sum = x * x + y * y + z * z + Polynomial(1 - r2);
    const Roots roots = roots_of(sum * sum - Polynomial(4) * (x * x + z * z), -1, 12, 1e-11L);
    ASSERT_NO_FATAL_FAILURE(compare(surface, 1.5, ray, roots, gradient, counts)) << i;
  }
  EXPECT_GT(counts.hits, 2000);
  EXPECT_LT(counts.open, 5);
}

TEST(ImplicitSurface, Tanglecube_MatchesOracle) {
  const auto part = [](auto x) { return x * x * x * x - Real{5} * (x * x); };
  check_polynomial(
      "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", 3.0, 20000,
      [&](auto x, auto y, auto z) { return part(x) + part(y) + part(z) + Real{11.8}; });
}

TEST(ImplicitSurface, Heart_MatchesOracle) {
  check_polynomial("(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3", 1.5, 10000,
                   [](auto x, auto y, auto z) {
                     const auto ball = x * x + Real{2.25} * (y * y) + z * z - Real{1};
                     const auto cube = z * z * z;
                     return ball * ball * ball - x * x * cube - Real{9.0 / 80.0} * (y * y * cube);
                   });
}

TEST(ImplicitSurface, DoubleCone_MatchesOracle) {
  check_polynomial("x^2 + y^2 - z^2", 1.0, 10000,
                   [](auto x, auto y, auto z) { return x * x + y * y - z * z; });
}

TEST(ImplicitSurface, ShellOfTwoThinSheets_MatchesOracle) {
  check_polynomial("(x^2 + y^2 + z^2 - 1)^2 - 1e-8", 1.5, 10000, [](auto x, auto y, auto z) {
    const auto ball = x * x + y * y + z * z - Real{1};
    return ball * ball - Real{1e-8};
  });
}

TEST(ImplicitSurface, Gyroid_MatchesOracle) {
  const ImplicitSurface surface = surface_of("sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)", 4.0);
  Random random(13);
  Counts counts;
  using std::cos, std::sin;
  const auto gradient = [](const auto& p) {
    return std::array{cos(p[0]) * cos(p[1]) - sin(p[2]) * sin(p[0]),
                      cos(p[1]) * cos(p[2]) - sin(p[0]) * sin(p[1]),
                      cos(p[2]) * cos(p[0]) - sin(p[1]) * sin(p[2])};
  };
  for (int i = 0; i < 3000; ++i) {
    ObjectRay ray = any_ray(random, 4.0);
    ray.direction = normalize(ray.direction);
    const auto at = [&](Real t) {
      const auto on = [&](int axis) {
        return Real{ray.origin[axis]} + t * Real{ray.direction[axis]};
      };
      return std::array{on(0), on(1), on(2)};
    };
    test::Bounded f;
    f.value = [&](Real t) {
      const auto p = at(t);
      return sin(p[0]) * cos(p[1]) + sin(p[1]) * cos(p[2]) + sin(p[2]) * cos(p[0]);
    };
    f.slope = [&](Real t) {
      const auto g = gradient(at(t));
      return g[0] * Real{ray.direction.x} + g[1] * Real{ray.direction.y} +
             g[2] * Real{ray.direction.z};
    };
    f.largest_slope = 2.45L;  // each component of the gradient is below the root of 2
    f.largest_bend = 3.42L;   // each row of the Hessian sums up to less than the root of 2, and 2
    Roots roots;
    const Real middle = static_cast<Real>(-dot(ray.origin, ray.direction));
    test::add_roots(f, std::fmax(middle - 7, Real{0}), middle + 7, roots);
    const auto normal = [&](const DVec3& p) {
      const auto g = gradient(std::array{p.x, p.y, p.z});
      return DVec3(g[0], g[1], g[2]);
    };
    ASSERT_NO_FATAL_FAILURE(compare(surface, 4.0, ray, roots, normal, counts)) << i;
  }
  EXPECT_GT(counts.hits, 2000);
  EXPECT_LT(counts.open, 5);
}

}  // namespace
}  // namespace lume::geometry
