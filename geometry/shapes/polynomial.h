// SPDX-License-Identifier: Apache-2.0
// Real roots of cubics and quartics. Between two neighbouring critical points a polynomial is
// monotone, so the roots of its derivative bracket its own roots, one each, and none is skipped
// (Yuksel 2022, "High-Performance Polynomial Root Finding for Graphics").
#pragma once

#include <array>
#include <cstddef>

namespace lume::geometry {

/// In ascending order. A double root is listed once or, where rounding has parted it, twice; a
/// polynomial that is zero everywhere has none.
struct RealRoots {
  std::array<double, 4> t{};
  std::size_t count = 0;

  [[nodiscard]] const double* begin() const { return t.data(); }
  [[nodiscard]] const double* end() const { return t.data() + count; }
};

/// The roots of c[0] + c[1] t + c[2] t^2 + c[3] t^3 with lower <= t <= upper, both finite. Leading
/// coefficients may be 0.
[[nodiscard]] RealRoots cubic_roots(const std::array<double, 4>& c, double lower, double upper);

/// The same of a polynomial of degree 4.
[[nodiscard]] RealRoots quartic_roots(const std::array<double, 5>& c, double lower, double upper);

}  // namespace lume::geometry
