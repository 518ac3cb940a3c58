// SPDX-License-Identifier: Apache-2.0
// Rays against an oracle that knows nothing of intervals. The hard cases have a file of their own.
#include "tests/geometry/shapes/implicit_rays.h"
#include "tests/geometry/shapes/line_oracle.h"
#include "tests/geometry/shapes/surface_checks.h"
#include "tests/support/cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace lume::geometry {
namespace {

using test::all_crossings;
using test::angle_between;
using test::any_ray;
using test::Polynomial;
using test::Random;
using test::Real;
using test::Roots;
using test::surface_of;

constexpr int k_rays = test::cases(100'000);  // at each surface

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
void check_polynomial(const std::string& text, double half_size, const Formula& formula,
                      int most_open = k_rays / 5000) {
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
  for (int i = 0; i < k_rays; ++i) {
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
  EXPECT_GT(counts.hits, k_rays / 5);
  EXPECT_GT(counts.misses, k_rays / 50);
  EXPECT_LE(counts.open, most_open);
}

TEST(ImplicitSurface, Sphere_MatchesOracle) {
  check_polynomial("x^2 + y^2 + z^2 - 1", 1.5,
                   [](auto x, auto y, auto z) { return x * x + y * y + z * z - 1; });
}

/// Of the torus around y of radius 1; `r2` is the square of its tube's radius.
auto torus_quartic(Real r2) {
  return [r2](auto x, auto y, auto z) {
    const auto sum = x * x + y * y + z * z + Real{1} - r2;
    return sum * sum - Real{4} * (x * x + z * z);
  };
}

TEST(ImplicitSurface, Torus_MatchesOracleOfItsQuartic) {
  // The 0.3 of the formula is the double nearest to it, and so is that of the oracle.
  check_polynomial("(x^2 + y^2 + z^2 + 1 - 0.3^2)^2 - 4*(x^2 + z^2)", 1.5,
                   torus_quartic(Real{0.3} * Real{0.3}));
}

TEST(ImplicitSurface, TorusWithRoot_MatchesOracleOfItsQuartic) {
  check_polynomial("(sqrt(x^2 + z^2) - 1)^2 + y^2 - 0.09", 1.5, torus_quartic(Real{0.09}));
}

TEST(ImplicitSurface, Tanglecube_MatchesOracle) {
  const auto part = [](auto x) { return x * x * x * x - Real{5} * (x * x); };
  check_polynomial(
      "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", 3.0,
      [&](auto x, auto y, auto z) { return part(x) + part(y) + part(z) + Real{11.8}; });
}

TEST(ImplicitSurface, Heart_MatchesOracle) {
  check_polynomial(
      "(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3", 1.5,
      [](auto x, auto y, auto z) {
        const auto ball = x * x + Real{2.25} * (y * y) + z * z - Real{1};
        const auto cube = z * z * z;
        return ball * ball * ball - x * x * cube - Real{9.0 / 80.0} * (y * y * cube);
      },
      k_rays / 3000);
}

TEST(ImplicitSurface, DoubleCone_MatchesOracle) {
  check_polynomial("x^2 + y^2 - z^2", 1.0,
                   [](auto x, auto y, auto z) { return x * x + y * y - z * z; });
}

TEST(ImplicitSurface, ShellOfTwoThinSheets_MatchesOracle) {
  check_polynomial("(x^2 + y^2 + z^2 - 1)^2 - 1e-8", 1.5, [](auto x, auto y, auto z) {
    const auto ball = x * x + y * y + z * z - Real{1};
    return ball * ball - Real{1e-8};
  });
}

/// The value and the gradient, in one array.
template <class T>
std::array<T, 4> gyroid(const std::array<T, 3>& p) {
  const std::array s = {std::sin(p[0]), std::sin(p[1]), std::sin(p[2])};
  const std::array c = {std::cos(p[0]), std::cos(p[1]), std::cos(p[2])};
  return {s[0] * c[1] + s[1] * c[2] + s[2] * c[0], c[0] * c[1] - s[2] * s[0],
          c[1] * c[2] - s[0] * s[1], c[2] * c[0] - s[1] * s[2]};
}

TEST(ImplicitSurface, Gyroid_MatchesOracle) {
  const ImplicitSurface surface = surface_of("sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)", 4.0);
  const auto gradient = [](const DVec3& p) {
    const auto f = gyroid<double>({p.x, p.y, p.z});
    return DVec3(f[1], f[2], f[3]);
  };
  Random random(13);
  Counts counts;
  for (int i = 0; i < k_rays; ++i) {
    ObjectRay ray = any_ray(random, 4.0);
    ray.direction = normalize(ray.direction);
    const auto along = [o = ray.origin, d = ray.direction](Real t) {
      const auto f = gyroid<Real>({o.x + t * d.x, o.y + t * d.y, o.z + t * d.z});
      return std::pair(f[0], f[1] * d.x + f[2] * d.y + f[3] * d.z);
    };
    // Each component of the gradient is below the root of 2; each row of the Hessian sums up to
    // less than the root of 2, and 2.
    const test::SlopeBounds bounds{2.45L, 3.42L};
    Real begin = 0;
    Real end = std::numeric_limits<Real>::infinity();
    for (int axis = 0; axis < 3; ++axis) {  // a little more than the box
      const Real o = ray.origin[axis];
      const Real reach = Real{4.01} / std::abs(ray.direction[axis]);
      const Real middle = -o / ray.direction[axis];
      begin = std::fmax(begin, middle - reach);
      end = std::fmin(end, middle + reach);
    }
    Roots roots;
    if (begin < end) test::add_roots(along, bounds, begin, end, roots);
    ASSERT_NO_FATAL_FAILURE(compare(surface, 4.0, ray, roots, gradient, counts)) << i;
  }
  EXPECT_GT(counts.hits, 2 * k_rays / 3);
  EXPECT_LE(counts.open, k_rays / 5000);
}

}  // namespace
}  // namespace lume::geometry
