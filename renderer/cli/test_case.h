// SPDX-License-Identifier: Apache-2.0
// One case of `lume test`, and all of them.
#pragma once

#include "renderer/cli/test_result.h"

#include <atomic>
#include <functional>
#include <vector>

namespace lume::cli {

/// Makes the image `repeat` times and judges each. Whatever goes wrong is the case's verdict.
[[nodiscard]] CaseResult run_case(const PlannedCase& planned, unsigned repeat,
                                  const std::atomic<bool>& cancel);

/// Judges the image that is there against the reference that is there now.
void judge_again(CaseResult& result);

/// Runs the cases, `jobs` at a time. `on_done` is told of each in the plan's order, never from two
/// threads at once. Those that have not begun when `cancel` turns true are not run.
[[nodiscard]] std::vector<CaseResult> run_cases(
    const std::vector<PlannedCase>& plan, unsigned jobs, unsigned repeat,
    const std::atomic<bool>& cancel, const std::function<void(const CaseResult&)>& on_done);

}  // namespace lume::cli
