// SPDX-License-Identifier: Apache-2.0
// Results of tests as JUnit XML, in the dialect that GitLab and the usual actions of GitHub read:
// https://github.com/testmoapp/junitxml collects what they have in common.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lume::io {

struct JunitCase {
  enum class Outcome { passed, failed, error, skipped };

  std::string name;
  Outcome outcome = Outcome::passed;
  std::string message;  ///< one line: why it was not passed
  std::string details;  ///< as many lines as are of use
  double seconds = 0.0;
  std::vector<std::pair<std::string, std::string>> properties;
};

struct JunitSuite {
  std::string name;
  std::string class_name;  ///< under which the cases are sorted
  std::string file;        ///< that describes them
  std::string timestamp;   ///< ISO 8601, of the beginning
  double seconds = 0.0;    ///< on the clock
  std::vector<JunitCase> cases;
};

/// The document, in UTF-8. Texts may be any bytes: what XML 1.0 does not allow (section 2.2), or is
/// no UTF-8, becomes U+FFFD.
[[nodiscard]] std::string to_junit(const JunitSuite& suite);

}  // namespace lume::io
