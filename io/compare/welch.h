// SPDX-License-Identifier: Apache-2.0
// Welch's test of two means with unequal variances (Welch 1947, "The generalization of 'Student's'
// problem when several different population variances are involved"), guarded against skew.
#pragma once

namespace lume::io {

/// A mean and how far it is to be trusted.
struct Estimate {
  double mean = 0.0;
  double variance = 0.0;  ///< of the mean
  double degrees = 1.0;   ///< of freedom of the variance; may be infinite
};

/// The same quantity from both sides.
struct EstimatePair {
  Estimate actual;
  Estimate expected;
  double base = 0.0;   ///< to be added to both means
  double scale = 0.0;  ///< typical absolute value, of which a share is rounding
};

/// The pair times a factor > 0, as a mean is a sum over its count.
[[nodiscard]] EstimatePair scaled(const EstimatePair& pair, double factor);

struct WelchTest {
  double difference = 0.0;  ///< actual - expected
  double standard_error = 0.0;
  double degrees = 1.0;
  double t = 0.0;  ///< >= 0; infinite if the difference is certain

  /// The true difference that is found with a probability of 95% where |t| > critical fails.
  [[nodiscard]] double detectable(double critical) const;
};

/// `variance_ratio` is what variance(actual) / variance(expected) should be by the numbers of
/// samples.
///
/// Light that few samples find is skewed: the side that happens to miss it is too dark and knows
/// nothing of its own variance, which is where Welch's test fails first. So the variance is at
/// least what both sides give together at that ratio. For equal ones of as many images this is
/// Welch's own variance. A difference of up to `rounding` * scale is none.
[[nodiscard]] WelchTest welch_test(const EstimatePair& pair, double variance_ratio,
                                   double rounding);

}  // namespace lume::io
