// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/interval_functions.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace lume::geometry {
namespace {

using test::Random;

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr int k_cases = 20000;

/// Numbers of all sizes: of some thousands, of about 1, and tiny ones; exactly 0 now and then.
double any_number(Random& random) {
  if (random.below(16) == 0) return 0.0;
  const double size = std::exp2(static_cast<double>(random.uniform(-30.0f, 12.0f)));
  return static_cast<double>(random.uniform(-1.0f, 1.0f)) * size;
}

Interval any_interval(Random& random) {
  const double a = any_number(random);
  if (random.below(8) == 0) return Interval(a);
  const double b = random.below(2) == 0 ? any_number(random) : a + 1e-6 * any_number(random);
  return {std::fmin(a, b), std::fmax(a, b)};
}

/// A number in the interval, often one of its ends.
double any_of(Random& random, const Interval& x) {
  const auto choice = random.below(4);
  if (choice == 0) return x.lower;
  if (choice == 1) return x.upper;
  const auto part = static_cast<double>(random.uniform());
  return std::fmin(x.upper, std::fmax(x.lower, x.lower + part * (x.upper - x.lower)));
}

bool holds(const Interval& x, long double value) {
  return static_cast<long double>(x.lower) <= value && value <= static_cast<long double>(x.upper);
}

/// What a function of long doubles says is in what the function of intervals says, where it has a
/// value.
template <class OfIntervals, class OfNumbers>
void check_unary(const OfIntervals& of_intervals, const OfNumbers& of_numbers) {
  Random random(1);
  int defined = 0;
  for (int i = 0; i < k_cases; ++i) {
    const Interval x = any_interval(random);
    const double p = any_of(random, x);
    const long double value = of_numbers(static_cast<long double>(p));
    if (!std::isfinite(value)) continue;
    ++defined;
    const Interval result = of_intervals(x);
    ASSERT_TRUE(holds(result, value))
        << p << " in [" << x.lower << ", " << x.upper << "]: " << static_cast<double>(value)
        << " not in [" << result.lower << ", " << result.upper << "]";
  }
  EXPECT_GT(defined, k_cases / 4);
}

template <class OfIntervals, class OfNumbers>
void check_binary(const OfIntervals& of_intervals, const OfNumbers& of_numbers) {
  Random random(2);
  int defined = 0;
  for (int i = 0; i < k_cases; ++i) {
    const Interval x = any_interval(random);
    const Interval y = any_interval(random);
    const double p = any_of(random, x);
    const double q = any_of(random, y);
    const long double value = of_numbers(static_cast<long double>(p), static_cast<long double>(q));
    if (!std::isfinite(value)) continue;
    ++defined;
    const Interval result = of_intervals(x, y);
    ASSERT_TRUE(holds(result, value)) << p << ", " << q << ": " << static_cast<double>(value)
                                      << " not in [" << result.lower << ", " << result.upper << "]";
  }
  EXPECT_GT(defined, k_cases / 4);
}

using Real = long double;

TEST(Interval, Arithmetic_HoldsEveryResult) {
  check_binary([](auto x, auto y) { return x + y; }, [](Real x, Real y) { return x + y; });
  check_binary([](auto x, auto y) { return x - y; }, [](Real x, Real y) { return x - y; });
  check_binary([](auto x, auto y) { return x * y; }, [](Real x, Real y) { return x * y; });
  check_binary([](auto x, auto y) { return x / y; }, [](Real x, Real y) { return x / y; });
  check_binary([](auto x, auto y) { return minimum(x, y); },
               [](Real x, Real y) { return std::fmin(x, y); });
  check_binary([](auto x, auto y) { return maximum(x, y); },
               [](Real x, Real y) { return std::fmax(x, y); });
  check_unary([](auto x) { return x * -0.3; }, [](Real x) { return x * Real{-0.3}; });
  check_unary([](auto x) { return x + 0.3; }, [](Real x) { return x + Real{0.3}; });
}

TEST(Interval, Functions_HoldEveryResult) {
  check_unary([](auto x) { return abs(x); }, [](Real x) { return std::abs(x); });
  check_unary([](auto x) { return sqrt(x); }, [](Real x) { return std::sqrt(x); });
  check_unary([](auto x) { return exp(x); }, [](Real x) { return std::exp(x); });
  check_unary([](auto x) { return log(x); }, [](Real x) { return std::log(x); });
  check_unary([](auto x) { return sin(x); }, [](Real x) { return std::sin(x); });
  check_unary([](auto x) { return cos(x); }, [](Real x) { return std::cos(x); });
  check_unary([](auto x) { return tan(x); }, [](Real x) { return std::tan(x); });
  check_unary([](auto x) { return atan(x); }, [](Real x) { return std::atan(x); });
}

TEST(Interval, Powers_HoldEveryResult) {
  for (const int n : {-7, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 9, 16, 31}) {
    check_unary([n](auto x) { return power(x, n); },
                [n](Real x) { return std::pow(x, static_cast<Real>(n)); });
  }
  for (const double e : {-1.5, -0.5, 0.3, 0.5, 2.5}) {
    check_unary([e](auto x) { return power(x, e); },
                [e](Real x) { return x < 0 ? Real{k_nan} : std::pow(x, Real{e}); });
  }
  check_binary([](auto x, auto y) { return power(x, y); },
               [](Real x, Real y) { return x < 0 ? Real{k_nan} : std::pow(x, y); });
}

TEST(Interval, Results_AreNoWiderThanNeeded) {
  const Interval sum = Interval(1.0, 2.0) + Interval(10.0, 20.0);
  EXPECT_NEAR(sum.lower, 11.0, 1e-14);
  EXPECT_NEAR(sum.upper, 22.0, 1e-14);
  const Interval square = power(Interval(-1.0, 2.0), 2);
  EXPECT_EQ(square.lower, 0.0);
  EXPECT_NEAR(square.upper, 4.0, 1e-14);
  const Interval product = Interval(-1.0, 2.0) * Interval(-3.0, 5.0);
  EXPECT_NEAR(product.lower, -6.0, 1e-14);
  EXPECT_NEAR(product.upper, 10.0, 1e-14);
  const Interval wave = sin(Interval(0.1, 0.2));
  EXPECT_NEAR(wave.lower, std::sin(0.1), 1e-15);
  EXPECT_NEAR(wave.upper, std::sin(0.2), 1e-15);
  EXPECT_EQ(sin(Interval(1.0, 2.0)).upper, 1.0);
  EXPECT_NEAR(sin(Interval(1.0, 2.0)).lower, std::sin(1.0), 1e-15);
  EXPECT_EQ(cos(Interval(3.0, 4.0)).lower, -1.0);
  EXPECT_TRUE(tan(Interval(-1.0, 1.0)).is_bounded());
}

TEST(Interval, DivisorWithZero_GivesHalfLineOrWholeLineOrNothing) {
  const Interval half = Interval(1.0, 2.0) / Interval(0.0, 4.0);
  EXPECT_NEAR(half.lower, 0.25, 1e-15);
  EXPECT_EQ(half.upper, k_infinity);
  const Interval negative = Interval(1.0, 2.0) / Interval(-4.0, 0.0);
  EXPECT_EQ(negative.lower, -k_infinity);
  EXPECT_NEAR(negative.upper, -0.25, 1e-15);
  const Interval inside = Interval(1.0, 2.0) / Interval(-1.0, 4.0);
  EXPECT_EQ(inside.lower, -k_infinity);
  EXPECT_EQ(inside.upper, k_infinity);
  EXPECT_TRUE((Interval(1.0, 2.0) / Interval(0.0)).is_empty());
}

TEST(Interval, OutsideOfTheDomain_IsCutOffOrEmpty) {
  EXPECT_EQ(sqrt(Interval(-4.0, 4.0)).lower, 0.0);
  EXPECT_NEAR(sqrt(Interval(-4.0, 4.0)).upper, 2.0, 1e-15);
  EXPECT_TRUE(sqrt(Interval(-4.0, -1.0)).is_empty());
  EXPECT_EQ(log(Interval(-4.0, 1.0)).lower, -k_infinity);
  EXPECT_TRUE(log(Interval(-4.0, -1.0)).is_empty());
  EXPECT_TRUE(power(Interval(-4.0, -1.0), 0.5).is_empty());
}

TEST(Interval, Infinity_NeverHidesAValue) {
  const Interval whole = Interval::whole();
  const Interval line = Interval::whole();
  const Interval ray(1.0, k_infinity);
  for (const Interval& result : {whole + line, whole - line, whole * line, whole * Interval(0.0),
                                 ray - Interval(2.0, k_infinity), tan(whole),
                                 Interval(-1.0, 1.0) * whole, exp(ray) - exp(ray), whole / line}) {
    EXPECT_TRUE(result.contains(0.0));
    EXPECT_TRUE(result.contains(-1e300) || result.lower >= -1.0);
  }
  EXPECT_TRUE((ray * ray).contains(1e300));
  EXPECT_TRUE(exp(Interval(-k_infinity, 1e4)).contains(1e308));
  EXPECT_EQ(sin(ray).lower, -1.0);
  EXPECT_EQ(sin(ray).upper, 1.0);
  EXPECT_TRUE(power(Interval(1e200, 1e300), 3).contains(std::numeric_limits<double>::max()));
}

TEST(Interval, ZeroTimesInfinity_IsZero) {
  const Interval below(-4.0, 0.0);
  for (const Interval& product :
       {below * Interval(-k_infinity, -1.0), Interval(-k_infinity, -1.0) * below,
        -(below * Interval(1.0, k_infinity)), Interval(1.0, k_infinity) * -below}) {
    EXPECT_TRUE(product.contains(0.0));
    EXPECT_TRUE(product.contains(1e300));
  }
}

TEST(Interval, EmptyOperand_GivesEmptyResult) {
  const Interval none = Interval::empty();
  const Interval one(1.0);
  for (const Interval& result : {none + one,
                                 one - none,
                                 none * one,
                                 Interval(0.0) * none,
                                 none / one,
                                 one / none,
                                 -none,
                                 abs(none),
                                 sqrt(none),
                                 exp(none),
                                 log(none),
                                 sin(none),
                                 cos(none),
                                 tan(none),
                                 atan(none),
                                 power(none, 2),
                                 power(none, -3),
                                 power(none, 0.5),
                                 power(one, none),
                                 minimum(none, one),
                                 maximum(one, none)}) {
    EXPECT_TRUE(result.is_empty());
    EXPECT_FALSE(result.contains(0.0));
  }
}

TEST(Interval, Underflow_KeepsTheSignOfWhatWasLost) {
  const Interval tiny(1e-200, 2e-200);
  EXPECT_GT((tiny * tiny).upper, 0.0);
  EXPECT_LT((tiny * -tiny).lower, 0.0);
}

}  // namespace
}  // namespace lume::geometry
