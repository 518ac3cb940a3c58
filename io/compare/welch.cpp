// SPDX-License-Identifier: Apache-2.0
#include "io/compare/welch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::io {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Degrees of freedom of the sum of two variances: Satterthwaite 1946, equation 17.
double welch_degrees(const Estimate& a, const Estimate& b) {
  const double sum = a.variance + b.variance;
  if (sum == 0.0) return a.degrees + b.degrees;
  const double u = a.variance / sum;
  const double v = b.variance / sum;
  const double inverse = u * u / a.degrees + v * v / b.degrees;
  return inverse == 0.0 ? k_infinity : 1.0 / inverse;
}

/// The share of the pooled variance that a side with `degrees` of freedom contributes.
double weight(double degrees, double others) {
  if (std::isinf(degrees)) return std::isinf(others) ? 0.5 : 1.0;
  return degrees / (degrees + others);
}

/// The variance of the difference if actual.variance = ratio * expected.variance.
double pooled_variance(const Estimate& actual, const Estimate& expected, double ratio) {
  const double w = weight(actual.degrees, expected.degrees);
  const double pooled = w * actual.variance + (1.0 - w) * ratio * expected.variance;
  return pooled + pooled / ratio;
}

}  // namespace

EstimatePair scaled(const EstimatePair& pair, double factor) {
  const auto of = [&](const Estimate& e) {
    return Estimate{e.mean * factor, e.variance * factor * factor, e.degrees};
  };
  return {of(pair.actual), of(pair.expected), pair.base * factor, pair.scale * factor};
}

double WelchTest::detectable(double critical) const {
  // The noncentral t distribution by its normal approximation (Abramowitz and Stegun 1964,
  // 26.7.10), solved for the noncentrality at which P(T > critical) is 0.96: to exchange labels
  // costs about a hundredth. A standard error comes out 1 - 1 / (4 degrees) too small on average.
  constexpr double k_z96 = 1.7506860712521692;
  const double spread = std::sqrt(1.0 + critical * critical / (2.0 * degrees));
  return (critical + k_z96 * spread / (1.0 - 0.25 / degrees)) * standard_error;
}

WelchTest welch_test(const EstimatePair& pair, double variance_ratio, double rounding) {
  const Estimate& actual = pair.actual;
  const Estimate& expected = pair.expected;
  WelchTest test;
  test.difference = actual.mean - expected.mean;
  test.degrees = welch_degrees(actual, expected);
  test.standard_error = std::sqrt(std::max(actual.variance + expected.variance,
                                           pooled_variance(actual, expected, variance_ratio)));
  const double excess = std::abs(test.difference) - rounding * pair.scale;
  if (excess <= 0.0) return test;
  test.t = test.standard_error > 0.0 ? excess / test.standard_error : k_infinity;
  return test;
}

}  // namespace lume::io
