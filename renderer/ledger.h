// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderer/ray_counts.h"

namespace lume::renderer {

struct RayTree;

/// What is written down while a camera ray is followed.
struct Ledger {
  RayCounts counts;
  RayTree* tree = nullptr;  ///< notes every ray there; null, as in all renders: notes none
};

}  // namespace lume::renderer
