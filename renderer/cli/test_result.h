// SPDX-License-Identifier: Apache-2.0
// What became of the cases of a run.
#pragma once

#include "io/compare/comparison.h"
#include "renderer/cli/test_history.h"
#include "renderer/cli/test_plan.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lume::cli {

enum class CaseVerdict {
  passed,
  accepted,  ///< the image has become the reference
  failed,
  missing,  ///< there is no reference
  flaky,    ///< not the same each time
  skipped,
  not_run,  ///< the run was interrupted before
};

/// "passed", "missing reference" and so on.
[[nodiscard]] const char* verdict_name(CaseVerdict verdict);
[[nodiscard]] bool is_failure(CaseVerdict verdict);

struct CaseResult {
  const PlannedCase* planned = nullptr;
  CaseVerdict verdict = CaseVerdict::not_run;
  std::string message;  ///< why, in one line; empty for what passed without remark
  std::vector<io::MetricVerdict> metrics;
  bool identical = false;       ///< to the reference, in every pixel
  std::vector<float> flip_map;  ///< of the image's pixels, where it is not identical; may be empty
  std::size_t color_image = 0;  ///< which of the file's images that is
  std::string pixels;           ///< a fingerprint of the image; empty if there is none
  double seconds = 0.0;
  std::vector<std::string> log;  ///< the last lines that a command said, if that failed
  std::string update;            ///< what became of the reference: "new: golden/a.exr"
  CaseHistory history;

  // In the case's folder; empty if there is none.
  std::filesystem::path actual;
  std::filesystem::path expected;
  std::filesystem::path difference;
};

struct TestRun {
  const TestOptions& options;
  std::string date;  ///< of the beginning: ISO 8601, UTC
  double seconds = 0.0;
  bool interrupted = false;
  std::vector<CaseResult> results;  ///< in the manifest's order

  [[nodiscard]] std::size_t count(CaseVerdict verdict) const;
  [[nodiscard]] std::size_t failures() const;
};

}  // namespace lume::cli
