// SPDX-License-Identifier: Apache-2.0
#include "io/compare/finding.h"

#include <cmath>
#include <limits>

namespace lume::io {

void record(const Finding& worst, const PictureShape& shape, StatisticalFamily& family) {
  const double expected = worst.pair.base + worst.pair.expected.mean;
  family.smallest_log_p = worst.log_p;
  family.passed = worst.log_p > family.log_threshold;
  family.x = worst.region.x;
  family.y = worst.region.y;
  family.width = worst.region.width;
  family.height = worst.region.height;
  family.channel = shape.channels[worst.channel];
  family.difference = worst.pair.actual.mean - worst.pair.expected.mean;
  if (family.difference == 0.0) return;
  family.relative_difference = expected == 0.0 ? std::numeric_limits<double>::infinity()
                                               : family.difference / std::abs(expected);
}

}  // namespace lume::io
