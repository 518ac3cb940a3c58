// SPDX-License-Identifier: Apache-2.0
#include "io/check/finding.h"

#include <algorithm>
#include <utility>

namespace lume::io::check {

void Findings::add(Severity severity, std::string code, std::string pointer, std::string message,
                   std::string advice) {
  const auto same = std::find_if(findings_.begin(), findings_.end(), [&](const Finding& finding) {
    return finding.code == code && finding.message == message && finding.severity == severity;
  });
  if (same != findings_.end()) {
    ++same->count;
    return;
  }
  findings_.push_back(
      {severity, std::move(code), std::move(pointer), std::move(message), std::move(advice)});
}

std::vector<Finding> Findings::sorted() const {
  std::vector<Finding> result = findings_;
  std::stable_sort(result.begin(), result.end(),
                   [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
  return result;
}

}  // namespace lume::io::check
