// SPDX-License-Identifier: Apache-2.0
// The result of `lume test`, and the forms in which it is shown.
#pragma once

#include "renderer/cli/test_result.h"

#include <string>

namespace lume::cli {

/// "lume test manifest.toml --jobs 2".
[[nodiscard]] std::string test_command(const TestOptions& options);
/// "18 cases: 16 passed, 2 failed".
[[nodiscard]] std::string summarize(const TestRun& run);
/// "failing since 2026-11-02 10:15 UTC, 3 of the last 20 runs"; empty for what has never failed.
[[nodiscard]] std::string describe_history(const CaseHistory& history);

/// The lines for one case, as soon as it is known.
[[nodiscard]] std::string case_lines(const CaseResult& result);

/// For people: what was not passed, and the sum.
[[nodiscard]] std::string test_to_text(const TestRun& run);
/// For programs; docs/image_tests.md lists the keys. Keys are only ever added.
[[nodiscard]] std::string test_to_json(const TestRun& run);
/// For CI servers.
[[nodiscard]] std::string test_to_junit(const TestRun& run);
/// One page with all pictures, that needs nothing else. Throws io::Error.
[[nodiscard]] std::string test_to_html(const TestRun& run);

}  // namespace lume::cli
