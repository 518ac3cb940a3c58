// SPDX-License-Identifier: Apache-2.0
// Numbers that carry their derivatives through a computation (automatic differentiation, forward
// mode): the derivatives are those of the formula itself and not of difference quotients.
#pragma once

#include "geometry/shapes/interval_functions.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace lume::geometry {

/// A value and its N partial derivatives, each a double or an Interval.
template <class T, std::size_t N>
struct Dual {
  T value;
  std::array<T, N> slope;

  Dual() = default;
  /// A constant.
  explicit Dual(double constant) : value(constant) { slope.fill(T(0.0)); }
  /// The variable whose derivatives these are.
  Dual(const T& v, const std::array<T, N>& s) : value(v), slope(s) {}
};

/// Applies `operation` to each partial derivative of a, or of a and b.
template <class T, std::size_t N, class Operation>
[[nodiscard]] inline Dual<T, N> derived(const T& value, const Dual<T, N>& a,
                                        const Operation& operation) {
  Dual<T, N> result(value, a.slope);
  for (std::size_t i = 0; i < N; ++i) result.slope[i] = operation(a.slope[i]);
  return result;
}
template <class T, std::size_t N, class Operation>
[[nodiscard]] inline Dual<T, N> derived(const T& value, const Dual<T, N>& a, const Dual<T, N>& b,
                                        const Operation& operation) {
  Dual<T, N> result(value, a.slope);
  for (std::size_t i = 0; i < N; ++i) result.slope[i] = operation(a.slope[i], b.slope[i]);
  return result;
}

/// The chain rule.
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> chain(const T& value, const T& outer_slope, const Dual<T, N>& a) {
  return derived(value, a, [&](const T& da) { return outer_slope * da; });
}

template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator-(const Dual<T, N>& a) {
  return derived(-a.value, a, [](const T& da) { return -da; });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator+(const Dual<T, N>& a, const Dual<T, N>& b) {
  return derived(a.value + b.value, a, b, [](const T& da, const T& db) { return da + db; });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator+(const Dual<T, N>& a, double b) {
  return {a.value + b, a.slope};
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator-(const Dual<T, N>& a, const Dual<T, N>& b) {
  return derived(a.value - b.value, a, b, [](const T& da, const T& db) { return da - db; });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator*(const Dual<T, N>& a, const Dual<T, N>& b) {
  return derived(a.value * b.value, a, b,
                 [&](const T& da, const T& db) { return da * b.value + a.value * db; });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator*(const Dual<T, N>& a, double b) {
  return derived(a.value * b, a, [&](const T& da) { return da * b; });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> operator/(const Dual<T, N>& a, const Dual<T, N>& b) {
  const T quotient = a.value / b.value;
  return derived(quotient, a, b,
                 [&](const T& da, const T& db) { return (da - quotient * db) / b.value; });
}

template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> abs(const Dual<T, N>& a) {
  using std::abs;
  return derived(abs(a.value), a,
                 [&](const T& da) { return where_lower(-a.value, a.value, da, -da); });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> minimum(const Dual<T, N>& a, const Dual<T, N>& b) {
  return derived(minimum(a.value, b.value), a, b,
                 [&](const T& da, const T& db) { return where_lower(a.value, b.value, da, db); });
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> maximum(const Dual<T, N>& a, const Dual<T, N>& b) {
  return derived(maximum(a.value, b.value), a, b,
                 [&](const T& da, const T& db) { return where_lower(b.value, a.value, da, db); });
}

template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> sqrt(const Dual<T, N>& a) {
  using std::sqrt;
  const T root = sqrt(a.value);
  return chain(root, slope_for_positive(a.value, T(0.5) / root), a);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> exp(const Dual<T, N>& a) {
  using std::exp;
  const T value = exp(a.value);
  return chain(value, value, a);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> log(const Dual<T, N>& a) {
  using std::log;
  return chain(log(a.value), slope_for_positive(a.value, T(1.0) / a.value), a);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> sin(const Dual<T, N>& a) {
  using std::cos, std::sin;
  return chain(sin(a.value), cos(a.value), a);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> cos(const Dual<T, N>& a) {
  using std::cos, std::sin;
  return chain(cos(a.value), -sin(a.value), a);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> tan(const Dual<T, N>& a) {
  using std::tan;
  const T value = tan(a.value);
  return chain(value, slope_without_pole(value, power(value, 2) + 1.0), a);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> atan(const Dual<T, N>& a) {
  using std::atan;
  return chain(atan(a.value), T(1.0) / (power(a.value, 2) + 1.0), a);
}

template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> power(const Dual<T, N>& base, int exponent) {
  if (exponent < 0) return Dual<T, N>(1.0) / power(base, -exponent);  // knows of the pole at 0
  if (exponent == 0) return Dual<T, N>(1.0);
  return chain(power(base.value, exponent), power(base.value, exponent - 1) * double(exponent),
               base);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> power(const Dual<T, N>& base, double exponent) {
  const T slope = power(base.value, exponent - 1.0) * exponent;
  return chain(power(base.value, exponent), slope_for_positive(base.value, slope), base);
}
template <class T, std::size_t N>
[[nodiscard]] inline Dual<T, N> power(const Dual<T, N>& base, const Dual<T, N>& exponent) {
  using std::log;
  const T value = power(base.value, exponent.value);
  return derived(value, base, exponent, [&](const T& da, const T& db) {
    const T slope = value * (log(base.value) * db + exponent.value * da / base.value);
    return slope_for_positive(base.value, slope);
  });
}

}  // namespace lume::geometry
