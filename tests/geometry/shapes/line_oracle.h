// SPDX-License-Identifier: Apache-2.0
// The crossings of lines with implicit surfaces, found in long double by means that have nothing in
// common with interval arithmetic.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace lume::test {

using Real = long double;

/// A polynomial of one variable; arithmetic with these expands a surface's formula along a line.
struct Polynomial {
  std::vector<Real> c;  ///< c[i] belongs to the i-th power

  Polynomial(Real constant) : c{constant} {}  // NOLINT(google-explicit-constructor): as numbers do
  Polynomial(Real constant, Real slope) : c{constant, slope} {}

  [[nodiscard]] Real operator()(Real t) const {
    Real sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
    return sum;
  }
  /// The sum of the terms' absolute values, which the rounding of the sum grows with.
  [[nodiscard]] Real size_at(Real t) const {
    Real sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * std::abs(t) + std::abs(c[i]);
    return sum;
  }
  [[nodiscard]] Polynomial derivative() const {
    Polynomial result(0);
    result.c.assign(c.size() > 1 ? c.size() - 1 : 1, 0);
    for (std::size_t i = 1; i < c.size(); ++i) result.c[i - 1] = static_cast<Real>(i) * c[i];
    return result;
  }
  friend Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    Polynomial sum = a.c.size() < b.c.size() ? b : a;
    const Polynomial& other = a.c.size() < b.c.size() ? a : b;
    for (std::size_t i = 0; i < other.c.size(); ++i) sum.c[i] += other.c[i];
    return sum;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(0);
    product.c.assign(a.c.size() + b.c.size() - 1, 0);
    for (std::size_t i = 0; i < a.c.size(); ++i) {
      for (std::size_t j = 0; j < b.c.size(); ++j) product.c[i + j] += a.c[i] * b.c[j];
    }
    return product;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return a + b * Polynomial(-1);
  }
};

/// The root of a monotone function between two values of different sign, by bisection.
template <class Function>
Real bisect(const Function& f, Real low, Real high) {
  const bool negative = f(low) < 0;
  for (int i = 0; i < 66; ++i) {
    const Real middle = (low + high) / 2;
    ((f(middle) < 0) == negative ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The roots of a function along a line in rising order, and whether the line comes so near to
/// touching the surface that their number is open.
struct Roots {
  std::vector<Real> t;
  bool is_open = false;
};

/// Between two neighbouring roots of its derivative a polynomial is monotone.
inline Roots roots_of(const Polynomial& p, Real low, Real high, Real margin) {
  Roots roots;
  if (p.c.size() < 2) return roots;
  std::vector<Real> ends{low};
  const Roots turns = roots_of(p.derivative(), low, high, 0);
  ends.insert(ends.end(), turns.t.begin(), turns.t.end());
  ends.push_back(high);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (std::abs(p(ends[i])) < margin * p.size_at(ends[i])) roots.is_open = true;
    if ((p(ends[i]) < 0) != (p(ends[i + 1]) < 0)) {
      roots.t.push_back(bisect(p, ends[i], ends[i + 1]));
    }
  }
  return roots;
}

/// The largest that a function's first and second derivatives become.
struct SlopeBounds {
  Real slope = 0;
  Real bend = 0;
};

/// Halves the line until the bounds say that a piece has no root or is monotone. f(t) is the
/// function's value and its slope.
template <class Function>
void add_roots(const Function& f, const SlopeBounds& bounds, Real low, Real high, Roots& roots) {
  const Real middle = (low + high) / 2;
  const Real radius = (high - low) / 2;
  const auto [value, slope] = f(middle);
  if (std::abs(value) > bounds.slope * radius) return;
  if (std::abs(slope) > bounds.bend * radius) {
    const auto value_at = [&](Real t) { return f(t).first; };
    if ((value_at(low) < 0) != (value_at(high) < 0)) {
      roots.t.push_back(bisect(value_at, low, high));
    }
    return;
  }
  if (radius < 1e-6L) {
    roots.is_open = true;
    return;
  }
  add_roots(f, bounds, low, middle, roots);
  add_roots(f, bounds, middle, high, roots);
}

}  // namespace lume::test
