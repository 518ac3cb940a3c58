// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lume::geometry {

/// The real roots of a t^2 + 2 b t + c = 0, the smaller first; both not a number if there are none.
/// Where a is 0 or nearly so one root is infinite or huge, and the other that of the line.
///
/// The sum b + sign(b) sqrt(b^2 - a c) never cancels, so each root is as exact as its coefficients
/// (Press et al., "Numerical Recipes", section 5.6).
[[nodiscard]] inline std::pair<double, double> solve_quadratic(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0.0)) {
    constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
    return {k_none, k_none};
  }
  const double root = std::sqrt(discriminant);
  const double q = -(b + std::copysign(root, b));
  if (q == 0.0) {  // b = 0 and a c = 0
    const double t = a != 0.0 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    return {t, t};
  }
  const double first = q / a;
  const double second = c / q;
  return {std::min(first, second), std::max(first, second)};
}

}  // namespace lume::geometry
