// SPDX-License-Identifier: Apache-2.0
// `lume test --update`: images that have been made become references.
#pragma once

#include "renderer/cli/test_result.h"

#include <atomic>

namespace lume::cli {

/// Writes the references that the options ask for, one after the other, and says in each result
/// what became of its own. What has no image, or not the same each time, changes nothing. Of cases
/// with the same reference the first writes it, and the others are held against that.
void update_references(TestRun& run, const std::atomic<bool>& cancel);

}  // namespace lume::cli
