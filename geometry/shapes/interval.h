// SPDX-License-Identifier: Apache-2.0
// Interval arithmetic: the result of a function on intervals holds every value that the function
// takes on numbers from them, rounding included. It proves that a function has no root somewhere.
// Moore, Kearfott and Cloud 2009, "Introduction to Interval Analysis".
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::geometry {

/// All real numbers with lower <= x <= upper; the ends may be infinite. An interval whose ends are
/// NaN is empty: the function has no value there, hence no root.
struct Interval {
  double lower;
  double upper;

  Interval() = default;
  explicit constexpr Interval(double value) : lower(value), upper(value) {}
  constexpr Interval(double low, double high) : lower(low), upper(high) {}

  [[nodiscard]] static constexpr Interval whole() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] static constexpr Interval empty() {
    return Interval(std::numeric_limits<double>::quiet_NaN());
  }
  [[nodiscard]] bool is_empty() const { return !(lower <= upper); }
  [[nodiscard]] bool contains(double x) const { return lower <= x && x <= upper; }
  [[nodiscard]] bool is_bounded() const {
    return lower >= -std::numeric_limits<double>::max() &&
           upper <= std::numeric_limits<double>::max();
  }
  [[nodiscard]] double radius() const { return 0.5 * (upper - lower); }
  /// The largest |x|.
  [[nodiscard]] double magnitude() const { return std::fmax(-lower, upper); }
};

/// Rounding by hand instead of by the processor's rounding mode, which compilers do not respect: by
/// at least one unit in the last place, and by more than all that underflow can lose. The smallest
/// step is a normal number, so it holds with denormals flushed to zero, too.
inline constexpr double k_smallest_step = 0x1p-1000;
[[nodiscard]] inline double rounded_down(double x, double units = 1.0) {
  return x - (std::abs(x) * (units * 0x1p-52) + k_smallest_step);
}
[[nodiscard]] inline double rounded_up(double x, double units = 1.0) {
  return x + (std::abs(x) * (units * 0x1p-52) + k_smallest_step);
}

/// [low, high] rounded outwards. Ends that are not numbers (infinity - infinity, or an overflow of
/// both ends) give the whole line, and operands without a value a result without one.
[[nodiscard]] inline Interval outwards_rounded(double low, double high, const Interval& a,
                                               const Interval& b) {
  const Interval result(rounded_down(low), rounded_up(high));
  if (result.lower <= result.upper) return result;
  return a.is_empty() || b.is_empty() ? Interval::empty() : Interval::whole();
}

[[nodiscard]] inline Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
  return outwards_rounded(a.lower + b.lower, a.upper + b.upper, a, b);
}
[[nodiscard]] inline Interval operator+(const Interval& a, double b) { return a + Interval(b); }
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) {
  return outwards_rounded(a.lower - b.upper, a.upper - b.lower, a, b);
}

/// 0 * infinity is NaN here. min and max pass over it if it is their second argument, where another
/// product is the 0 that it stands for; if it is the first of all, the result is the whole line.
[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) {
  const double ll = a.lower * b.lower;
  const double lu = a.lower * b.upper;
  const double ul = a.upper * b.lower;
  const double uu = a.upper * b.upper;
  return outwards_rounded(std::min(std::min(std::min(ll, lu), ul), uu),
                          std::max(std::max(std::max(ll, lu), ul), uu), a, b);
}
[[nodiscard]] inline Interval operator*(const Interval& a, double b) {
  const double first = a.lower * b;
  const double second = a.upper * b;
  return outwards_rounded(std::min(first, second), std::max(first, second), a, a);
}

/// A divisor that reaches 0 from one side gives a half line, one that has 0 inside the whole line.
[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty() || (b.lower == 0.0 && b.upper == 0.0)) return Interval::empty();
  if (b.lower < 0.0 && b.upper > 0.0) return Interval::whole();
  if (b.upper <= 0.0) return -a / -b;
  constexpr double k_infinity = std::numeric_limits<double>::infinity();
  // A quotient of 0 by 0 or infinity by infinity is NaN, and then the whole line.
  const double low =
      a.lower < 0.0 && b.lower == 0.0 ? -k_infinity : a.lower / (a.lower < 0.0 ? b.lower : b.upper);
  const double high =
      a.upper > 0.0 && b.lower == 0.0 ? k_infinity : a.upper / (a.upper > 0.0 ? b.lower : b.upper);
  return outwards_rounded(low, high, a, b);
}

/// The smallest interval around both.
[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::whole();
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

}  // namespace lume::geometry
