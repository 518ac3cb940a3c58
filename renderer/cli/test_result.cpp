// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/test_result.h"

#include <algorithm>

namespace lume::cli {

const char* verdict_name(CaseVerdict verdict) {
  switch (verdict) {
    case CaseVerdict::passed:
      return "passed";
    case CaseVerdict::accepted:
      return "accepted";
    case CaseVerdict::failed:
      return "failed";
    case CaseVerdict::missing:
      return "missing reference";
    case CaseVerdict::flaky:
      return "flaky";
    case CaseVerdict::skipped:
      return "skipped";
    case CaseVerdict::not_run:
      break;
  }
  return "not run";
}

bool is_failure(CaseVerdict verdict) {
  return verdict == CaseVerdict::failed || verdict == CaseVerdict::missing ||
         verdict == CaseVerdict::flaky;
}

std::size_t TestRun::count(CaseVerdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(),
                    [&](const CaseResult& result) { return result.verdict == verdict; }));
}

std::size_t TestRun::failures() const {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(),
                    [](const CaseResult& result) { return is_failure(result.verdict); }));
}

}  // namespace lume::cli
