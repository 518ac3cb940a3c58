// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/polynomial.h"

#include "geometry/shapes/quadratic.h"

#include <cmath>
#include <limits>
#include <utility>

namespace lume::geometry {
namespace {

template <std::size_t size>
std::pair<double, double> value_and_slope(const std::array<double, size>& c, double t) {
  double value = c[size - 1];
  double slope = 0.0;
  for (std::size_t i = size - 1; i-- > 0;) {
    slope = slope * t + value;
    value = value * t + c[i];
  }
  return {value, slope};
}

/// The sign of a value, 0 where Horner's scheme cannot tell (Higham 2002, "Accuracy and Stability
/// of Numerical Algorithms", equation 5.3: the error is at most 2 n units of the sum of |c[i]
/// t^i|).
template <std::size_t size>
int sign_at(const std::array<double, size>& c, double t) {
  double value = c[size - 1];
  double terms = std::abs(value);
  for (std::size_t i = size - 1; i-- > 0;) {
    value = value * t + c[i];
    terms = terms * std::abs(t) + std::abs(c[i]);
  }
  const double error = static_cast<double>(size - 1) * std::numeric_limits<double>::epsilon();
  if (value > error * terms) return 1;
  return value < -error * terms ? -1 : 0;
}

/// The root between two points where a monotone polynomial has the signs `sign_lower` and its
/// opposite: Newton's method, which a bisection replaces wherever it would leave the bracket.
template <std::size_t size>
double root_between(const std::array<double, size>& c, double lower, double upper, int sign_lower) {
  constexpr int k_max_steps = 100;  // Bisections alone take 64 or so.
  double t = 0.5 * (lower + upper);
  for (int step = 0; step < k_max_steps; ++step) {
    const auto [value, slope] = value_and_slope(c, t);
    if (value == 0.0) return t;
    ((value < 0.0) == (sign_lower < 0) ? lower : upper) = t;
    double next = t - value / slope;
    if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
    const double tolerance = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(next);
    if (std::abs(next - t) <= tolerance || next == lower || next == upper) return next;
    t = next;
  }
  return t;
}

template <std::size_t size>
RealRoots roots(const std::array<double, size>& c, double lower, double upper) {
  std::array<double, size - 1> derivative{};
  for (std::size_t i = 1; i < size; ++i) derivative[i - 1] = static_cast<double>(i) * c[i];
  RealRoots knots = roots(derivative, lower, upper);
  if (knots.count < knots.t.size()) knots.t[knots.count] = upper;

  RealRoots found;
  const auto add = [&](double t) {
    const bool is_new = found.count == 0 || found.t[found.count - 1] < t;
    if (is_new && found.count < size - 1) found.t[found.count++] = t;
  };
  double from = lower;
  int from_sign = sign_at(c, lower);
  int last_sign = from_sign;  // the last that was not 0
  if (from_sign == 0) add(lower);
  for (std::size_t i = 0; i <= knots.count; ++i) {
    const double to = knots.t[i];
    const int to_sign = sign_at(c, to);
    if (to_sign == 0) add(to);
    if (from_sign * to_sign < 0) add(root_between(c, from, to, from_sign));
    if (to_sign != 0) last_sign = to_sign;
    from = to;
    from_sign = to_sign;
  }
  if (last_sign == 0) found.count = 0;  // zero everywhere
  return found;
}

template <>
RealRoots roots(const std::array<double, 3>& c, double lower, double upper) {
  RealRoots found;
  const auto [first, second] = solve_quadratic(c[2], 0.5 * c[1], c[0]);
  if (first >= lower && first <= upper) found.t[found.count++] = first;
  if (second > first && second >= lower && second <= upper) found.t[found.count++] = second;
  return found;
}

}  // namespace

RealRoots cubic_roots(const std::array<double, 4>& c, double lower, double upper) {
  return roots(c, lower, upper);
}

RealRoots quartic_roots(const std::array<double, 5>& c, double lower, double upper) {
  return roots(c, lower, upper);
}

}  // namespace lume::geometry
