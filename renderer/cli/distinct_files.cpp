// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/distinct_files.h"

#include "renderer/cli/exit_codes.h"
#include "renderer/cli/text.h"

#include <fmt/format.h>

#include <system_error>

namespace lume::cli {
namespace {

/// One form for all spellings of a path, whether or not the file is there.
std::filesystem::path canonical_path(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path result =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path), ignored);
  return result.empty() ? path : result;
}

}  // namespace

void DistinctFiles::read(const std::string& role, const std::filesystem::path& path) {
  taken_.emplace_back(role, canonical_path(path));
}

void DistinctFiles::write(const std::string& role, const std::filesystem::path& path) {
  const std::filesystem::path canonical = canonical_path(path);
  for (const auto& [other_role, other] : taken_) {
    if (canonical == other) {
      throw UsageError(fmt::format("{} and {} are the same file: {}", other_role, role,
                                   printable(canonical.string())));
    }
  }
  taken_.emplace_back(role, canonical);
}

}  // namespace lume::cli
