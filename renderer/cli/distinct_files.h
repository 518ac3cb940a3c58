// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace lume::cli {

/// The files that a command reads and writes. No written file may be another one that is written,
/// nor one that is read, however their paths are spelt.
class DistinctFiles {
 public:
  /// `role` is what the user calls it: "the scene", "--svg".
  void read(const std::string& role, const std::filesystem::path& path);
  /// Throws UsageError if the file is taken.
  void write(const std::string& role, const std::filesystem::path& path);

 private:
  std::vector<std::pair<std::string, std::filesystem::path>> taken_;
};

}  // namespace lume::cli
