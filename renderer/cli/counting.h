// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/accelerators/accelerator.h"

#include <string>
#include <vector>

namespace lume::cli {

/// The structures that say what a query looked at.
[[nodiscard]] std::vector<std::string> counting_accelerators();

/// Throws UsageError if the structure does not count; `option` is what asked for it.
void check_counts_cost(const std::string& option, const std::string& name,
                       const geometry::Accelerator& accelerator);

}  // namespace lume::cli
