// SPDX-License-Identifier: Apache-2.0
// The elementary functions of intervals.
#pragma once

#include "geometry/shapes/interval.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace lume::geometry {

/// base^exponent by repeated squaring, for all exponents but the smallest int.
[[nodiscard]] inline double power(double base, int exponent) {
  double result = 1.0;
  double square = base;
  for (int rest = std::abs(exponent); rest > 0; rest /= 2) {
    if (rest % 2 == 1) result *= square;
    if (rest > 1) square *= square;
  }
  return exponent < 0 ? 1.0 / result : result;
}

/// base^exponent as real analysis has it: without a value for negative bases, whatever the
/// exponent.
[[nodiscard]] inline double power(double base, double exponent) {
  // The library's pow makes 1 of some operands that are not numbers.
  const bool has_value = base >= 0.0 && !std::isnan(exponent);
  return has_value ? std::pow(base, exponent) : std::numeric_limits<double>::quiet_NaN();
}

/// The smaller and the larger of two numbers; NaN if one of them is.
[[nodiscard]] inline double minimum(double a, double b) { return a < b || std::isnan(a) ? a : b; }
[[nodiscard]] inline double maximum(double a, double b) { return a > b || std::isnan(a) ? a : b; }
[[nodiscard]] inline Interval minimum(const Interval& a, const Interval& b) {
  return {minimum(a.lower, b.lower), minimum(a.upper, b.upper)};
}
[[nodiscard]] inline Interval maximum(const Interval& a, const Interval& b) {
  return {maximum(a.lower, b.lower), maximum(a.upper, b.upper)};
}

/// `of_a` where a <= b, else `of_b`; either where that is open.
[[nodiscard]] inline double where_lower(double a, double b, double of_a, double of_b) {
  return a <= b ? of_a : of_b;
}
[[nodiscard]] inline Interval where_lower(const Interval& a, const Interval& b,
                                          const Interval& of_a, const Interval& of_b) {
  if (a.upper <= b.lower) return of_a;
  if (b.upper <= a.lower) return of_b;
  return hull(of_a, of_b);
}

/// The slope of a function that has a value for positive x only. Nothing is known of it where x may
/// be something else: there the function's graph has gaps, which no finite slope may bridge.
[[nodiscard]] inline double slope_for_positive(double /*x*/, double slope) { return slope; }
[[nodiscard]] inline Interval slope_for_positive(const Interval& x, const Interval& slope) {
  return x.lower <= 0.0 ? Interval::whole() : slope;
}

/// The same for a function with poles: none may be between its values if these are not bounded.
[[nodiscard]] inline double slope_without_pole(double /*value*/, double slope) { return slope; }
[[nodiscard]] inline Interval slope_without_pole(const Interval& value, const Interval& slope) {
  return value.is_bounded() ? slope : Interval::whole();
}

[[nodiscard]] inline Interval abs(const Interval& x) {
  if (x.lower >= 0.0) return x;
  if (x.upper <= 0.0) return -x;
  return x.is_empty() ? x : Interval(0.0, x.magnitude());
}

/// The C library's functions are off by less than one unit in the last place (glibc's manual,
/// section 19.7); other libraries' by a few.
inline constexpr double k_library_units = 4.0;

[[nodiscard]] inline Interval sqrt(const Interval& x) {
  if (!(x.upper >= 0.0)) return Interval::empty();
  return {x.lower <= 0.0 ? 0.0 : std::fmax(0.0, rounded_down(std::sqrt(x.lower))),
          rounded_up(std::sqrt(x.upper))};
}

[[nodiscard]] inline Interval exp(const Interval& x) {
  if (x.is_empty()) return x;
  const double low = std::fmin(std::exp(x.lower), std::numeric_limits<double>::max());
  return {std::fmax(0.0, rounded_down(low, k_library_units)),
          rounded_up(std::exp(x.upper), k_library_units)};
}

[[nodiscard]] inline Interval log(const Interval& x) {
  if (!(x.upper > 0.0)) return Interval::empty();
  const double low = x.lower <= 0.0 ? -std::numeric_limits<double>::infinity()
                                    : rounded_down(std::log(x.lower), k_library_units);
  return {low, rounded_up(std::log(x.upper), k_library_units)};
}

[[nodiscard]] inline Interval atan(const Interval& x) {
  return {rounded_down(std::atan(x.lower), k_library_units),
          rounded_up(std::atan(x.upper), k_library_units)};
}

/// True if x may hold a point (k + phase) * period with a whole k. Angles so large that their
/// doubles are sparse always may.
[[nodiscard]] inline bool may_contain_multiple(const Interval& x, double period, double phase) {
  if (!(x.magnitude() < 1e6)) return true;
  constexpr double k_error = 1e-8;  // far above the rounding of quotients below 1e6
  return std::floor(x.upper / period - phase + k_error) >
         std::floor(x.lower / period - phase - k_error);
}

/// `low` and `high` are the function's values at the ends of x; `peak` is where in its period it
/// has its maximum, half a period from its minimum.
[[nodiscard]] inline Interval wave(const Interval& x, double low, double high, double peak) {
  constexpr double k_period = 2.0 * std::numbers::pi;
  if (x.is_empty()) return x;
  const bool has_top = may_contain_multiple(x, k_period, peak);
  const bool has_bottom = may_contain_multiple(x, k_period, peak + 0.5);
  return {has_bottom ? -1.0 : std::fmax(-1.0, rounded_down(std::fmin(low, high), k_library_units)),
          has_top ? 1.0 : std::fmin(1.0, rounded_up(std::fmax(low, high), k_library_units))};
}
[[nodiscard]] inline Interval sin(const Interval& x) {
  return wave(x, std::sin(x.lower), std::sin(x.upper), 0.25);
}
[[nodiscard]] inline Interval cos(const Interval& x) {
  return wave(x, std::cos(x.lower), std::cos(x.upper), 0.0);
}

[[nodiscard]] inline Interval tan(const Interval& x) {
  if (x.is_empty()) return x;
  if (may_contain_multiple(x, std::numbers::pi, 0.5)) return Interval::whole();
  return {rounded_down(std::tan(x.lower), k_library_units),
          rounded_up(std::tan(x.upper), k_library_units)};
}

/// Each multiplication of the repeated squaring is off by half a unit at most, of the result's
/// units `exponent` times that.
[[nodiscard]] inline Interval power(const Interval& base, int exponent) {
  if (exponent < 0) return Interval(1.0) / power(base, -exponent);
  if (exponent == 0) return Interval(1.0);
  const double units = exponent;
  const Interval x = exponent % 2 == 0 ? abs(base) : base;
  const double low = power(x.lower, exponent);
  const Interval result(
      rounded_down(std::fmin(low, std::numeric_limits<double>::max()), units),
      rounded_up(std::fmax(power(x.upper, exponent), -std::numeric_limits<double>::max()), units));
  if (base.is_empty()) return base;
  return x.lower >= 0.0 ? Interval(std::fmax(0.0, result.lower), result.upper) : result;
}

[[nodiscard]] inline Interval power(const Interval& base, const Interval& exponent) {
  if (!(base.upper >= 0.0) || exponent.is_empty()) return Interval::empty();
  if (base.upper == 0.0) return {0.0, std::numeric_limits<double>::infinity()};
  return exp(exponent * log(base));
}
[[nodiscard]] inline Interval power(const Interval& base, double exponent) {
  return power(base, Interval(exponent));
}

}  // namespace lume::geometry
