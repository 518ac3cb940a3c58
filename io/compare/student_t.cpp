// SPDX-License-Identifier: Apache-2.0
#include "io/compare/student_t.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lume::io {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_normal_degrees = 1e8;
const double k_log_sqrt_pi = -std::log(std::numbers::inv_sqrtpi);

/// ln(Gamma(a + 1/2) / Gamma(a)). std::lgamma would cancel for large a, and writes a global.
double log_gamma_ratio(double a) {
  // By Gamma(x + 1) = x Gamma(x) up to where the expansion for large a (DLMF 5.11.13) has
  // converged.
  double correction = 0.0;
  while (a < 32.0) {
    correction += std::log(a / (a + 0.5));
    a += 1.0;
  }
  const double a2 = a * a;
  return correction + 0.5 * std::log(a) +
         (-1.0 / 8.0 + (1.0 / 192.0 - 1.0 / (640.0 * a2)) / a2) / a;
}

/// The continued fraction of I_x(a, b), DLMF 8.17.22, by the algorithm of Lentz as modified by
/// Thompson and Barnett 1986. Its terms: d_2m = m (b - m) x / ((a + 2m - 1) (a + 2m)) and
/// d_(2m+1) = -(a + m) (a + b + m) x / ((a + 2m) (a + 2m + 1)).
double beta_fraction(double a, double b, double x) {
  constexpr double k_tiny = 1e-300;
  constexpr int k_most_terms = 100000;  // it takes about sqrt(max(a, b))
  const auto not_zero = [](double v) { return std::abs(v) < k_tiny ? k_tiny : v; };
  double numerator = 1.0;
  double denominator = 0.0;
  double value = 1.0;
  for (int i = 1; i <= k_most_terms; ++i) {
    const bool even = i % 2 == 0;
    const double m = even ? 0.5 * i : 0.5 * (i - 1);
    const double d = even ? m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
                          : -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    denominator = 1.0 / not_zero(1.0 + d * denominator);
    numerator = not_zero(1.0 + d / numerator);
    value *= numerator * denominator;
    if (std::abs(numerator * denominator - 1.0) < 1e-15) break;
  }
  return 1.0 / value;
}

}  // namespace

double normal_two_sided_log_p(double z) {
  const double x = std::abs(z) / std::numbers::sqrt2;
  if (x < 20.0) return std::log(std::erfc(x));
  if (x == k_infinity) return -k_infinity;
  // DLMF 7.12.1; erfc itself would soon be 0.
  const double s = 1.0 / (2.0 * x * x);
  const double series = 1.0 - s * (1.0 - 3.0 * s * (1.0 - 5.0 * s * (1.0 - 7.0 * s)));
  return -x * x - std::log(x) - k_log_sqrt_pi + std::log(series);
}

double student_two_sided_log_p(double t, double degrees) {
  t = std::abs(t);
  if (degrees > k_normal_degrees) return normal_two_sided_log_p(t);
  if (t == 0.0) return 0.0;
  if (t == k_infinity) return -k_infinity;
  // P = I_x(a, 1/2) with x = degrees / (degrees + t^2) and a = degrees / 2 (DLMF 8.17.2; Abramowitz
  // and Stegun 1964, 26.7.1), from ln(t^2 / degrees), which does not overflow.
  const double a = 0.5 * degrees;
  const double log_r = 2.0 * std::log(t) - std::log(degrees);
  const double r = std::exp(log_r);
  const double log_x = r == k_infinity ? -log_r : -std::log1p(r);
  const double log_y = r == 0.0 ? log_r : -std::log1p(1.0 / r);
  const double log_front = a * log_x + 0.5 * log_y + log_gamma_ratio(a) - k_log_sqrt_pi;
  const double x = std::exp(log_x);
  if (x < (a + 1.0) / (a + 2.5)) {
    return std::min(0.0, log_front - std::log(a) + std::log(beta_fraction(a, 0.5, x)));
  }
  const double inside = 2.0 * std::exp(log_front) * beta_fraction(0.5, a, std::exp(log_y));
  return std::log1p(-std::min(inside, 1.0));
}

double student_critical(double log_p, double degrees) {
  if (log_p >= 0.0) return 0.0;
  if (log_p == -k_infinity) return k_infinity;
  // The tail falls with t: between bounds of ln t first by doubling, then by halving.
  const auto beyond = [&](double log_t) {
    return student_two_sided_log_p(std::exp(log_t), degrees) > log_p;
  };
  double step = 1.0;
  double low = -1.0;
  double high = 1.0;
  for (; !beyond(low) && low > -700.0; step *= 2.0) low -= step;
  for (step = 1.0; beyond(high) && high < 700.0; step *= 2.0) high += step;
  for (int i = 0; i < 200 && high - low > 1e-15 * std::max(1.0, std::abs(low)); ++i) {
    const double middle = 0.5 * (low + high);
    (beyond(middle) ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

}  // namespace lume::io
