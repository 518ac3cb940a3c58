// SPDX-License-Identifier: Apache-2.0
// What `lume compare` found, told in several ways.
#pragma once

#include "io/compare/comparison.h"
#include "io/compare/statistical_test.h"
#include "renderer/cli/compare_options.h"
#include "renderer/cli/exit_codes.h"

#include <optional>
#include <string>

namespace lume::cli {

/// Both files as they were compared: without the channels that were to be ignored.
struct CompareDocument {
  CompareOptions options;
  io::ImageFile actual;
  io::ImageFile expected;
  io::Comparison comparison;
  std::optional<io::StatisticalResult> statistics;  ///< of noisy images, in place of limits

  [[nodiscard]] bool passed() const {
    return comparison.refusal == io::Refusal::none &&
           (statistics ? statistics->passed : comparison.passed);
  }
};

[[nodiscard]] ExitCode exit_code(const CompareDocument& document);

/// "passed", "failed", "refused": the word that all reports use.
[[nodiscard]] std::string verdict(const CompareDocument& document);
/// In one line, why.
[[nodiscard]] std::string reason(const CompareDocument& document);

[[nodiscard]] std::string compare_to_text(const CompareDocument& document);
[[nodiscard]] std::string compare_to_json(const CompareDocument& document);
[[nodiscard]] std::string compare_to_html(const CompareDocument& document);

/// The difference of the colours beside the map of FLIP as a picture, or as values in an .exr.
/// Throws io::Error.
void write_difference(const std::string& file, const CompareDocument& document);

}  // namespace lume::cli
