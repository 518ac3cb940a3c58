// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/compare/regions.h"

namespace lume::io {

/// The worst of some tests.
struct Finding {
  Region region;
  std::size_t channel = 0;
  EstimatePair pair;
  double log_p = 0.0;
};

/// Enters the worst test of all into the family, and whether it fails.
void record(const Finding& worst, const PictureShape& shape, StatisticalFamily& family);

}  // namespace lume::io
