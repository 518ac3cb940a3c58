// SPDX-License-Identifier: Apache-2.0
// Tails of the normal and of Student's t distribution. Logarithms throughout: of a million pixels
// the worst may have a probability that no double holds. Degrees of freedom are real, as Welch's
// test needs them; above 1e8, infinity included, t is the normal distribution.
#pragma once

namespace lume::io {

/// ln P(|Z| >= |z|) of a standard normal Z.
[[nodiscard]] double normal_two_sided_log_p(double z);

/// ln P(|T| >= |t|) of Student's t with degrees > 0. 0 at t = 0, -infinity at infinity.
[[nodiscard]] double student_two_sided_log_p(double t, double degrees);

/// The t >= 0 with ln P(|T| >= t) = log_p <= 0; infinity for log_p = -infinity.
[[nodiscard]] double student_critical(double log_p, double degrees);

}  // namespace lume::io
