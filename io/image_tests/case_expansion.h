// SPDX-License-Identifier: Apache-2.0
// From a [[case]] of a manifest to the cases that it stands for.
#pragma once

#include "io/image_tests/case_values.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lume::io {

/// A case that overrides may still change.
struct CaseDraft {
  TestCase made;  ///< name, line and where the image comes from
  std::string stem;
  CaseValues values;
};

[[nodiscard]] std::vector<std::string> case_keys();

/// One draft for each file that the scene's globs stand for, else one. Relative paths start in
/// `folder`. Throws ManifestError.
[[nodiscard]] std::vector<CaseDraft> expand_case(const std::filesystem::path& folder,
                                                 const std::filesystem::path& file,
                                                 const ManifestTable& table,
                                                 const CaseValues& defaults);

/// Fills in what the values say, now that they are final, and sees whether they go together.
/// Throws ManifestError.
[[nodiscard]] TestCase finish_case(const std::filesystem::path& file, CaseDraft draft,
                                   const std::filesystem::path& references);

}  // namespace lume::io
