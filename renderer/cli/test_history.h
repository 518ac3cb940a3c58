// SPDX-License-Identifier: Apache-2.0
// What earlier runs of `lume test` found, in a file beside their reports.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lume::cli {

/// What the history knows of one case, the present run included.
struct CaseHistory {
  std::string failing_since;  ///< when the present series of failures began; empty if it passed
  std::size_t failures = 0;   ///< among `runs`
  std::size_t runs = 0;       ///< those that are kept and in which it was run
};

/// One case's result in one run.
struct HistoryEntry {
  std::string name;
  std::string verdict;
  bool failed = false;
};

class TestHistory {
 public:
  /// An empty history if the file is not there; also if it is broken, and then `warning` says so.
  static TestHistory read(const std::filesystem::path& file, std::string& warning);

  /// `date` is ISO 8601. Cases that were not run have no entry. The oldest runs are forgotten.
  void add_run(const std::string& date, const std::vector<HistoryEntry>& entries);
  [[nodiscard]] CaseHistory of(const std::string& name) const;
  /// Throws io::Error.
  void write(const std::filesystem::path& file) const;

 private:
  struct Run {
    std::string date;
    std::map<std::string, std::string> verdicts;  ///< by name
  };

  std::vector<Run> runs_;                             ///< the oldest first
  std::map<std::string, std::string> failing_since_;  ///< by name; outlives the runs
};

}  // namespace lume::cli
