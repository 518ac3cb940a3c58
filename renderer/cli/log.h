// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lume::cli {

enum class Verbosity { quiet, normal, verbose };

/// Sends spdlog's default logger to stderr, one line each: "lume: ...", "lume: warning: ...".
/// stdout is left to results. Quiet keeps warnings and errors.
void start_log(Verbosity verbosity);

}  // namespace lume::cli
