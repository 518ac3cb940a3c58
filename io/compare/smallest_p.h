// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/compare/student_t.h"

#include <limits>

namespace lume::io {

/// Keeps the smallest of many probabilities. Few tests come near it, so few have theirs computed.
class SmallestP {
 public:
  /// Looks for probabilities below exp(log_p).
  explicit SmallestP(double log_p = 0.0) { set(log_p); }

  /// True if the test's ln p + log_factor is smaller than all before.
  bool offer(double t, double degrees, double log_factor = 0.0) {
    // For no degrees of freedom is p smaller than for infinitely many.
    if (t < least_t_) return false;
    const double log_p = student_two_sided_log_p(t, degrees) + log_factor;
    if (log_p >= log_p_) return false;
    set(log_p);
    return true;
  }

  [[nodiscard]] double log_p() const { return log_p_; }

 private:
  void set(double log_p) {
    log_p_ = log_p;
    // A little less, lest rounding leaves out what is as small.
    least_t_ = (1.0 - 1e-9) * student_critical(log_p, std::numeric_limits<double>::infinity());
  }

  double log_p_ = 0.0;
  double least_t_ = 0.0;
};

}  // namespace lume::io
