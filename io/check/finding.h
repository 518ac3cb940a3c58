// SPDX-License-Identifier: Apache-2.0
// What `lume check` says of a scene before it is rendered.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lume::io::check {

enum class Severity {
  error,    ///< the file is refused
  warning,  ///< it breaks a rule of glTF, or is drawn otherwise than was probably meant
  advice    ///< it is right, but could be better
};

struct Finding {
  Severity severity = Severity::warning;
  std::string code;       ///< what kind of thing it is, for programs: "thin-glass"
  std::string pointer;    ///< where in the file (RFC 6901); empty: the file as a whole
  std::string message;    ///< what is there
  std::string advice;     ///< what to do about it
  std::size_t count = 1;  ///< how many places are alike; `pointer` is the first
};

/// Collects what is found. The same thing said of several places is one finding with a count.
class Findings {
 public:
  void add(Severity severity, std::string code, std::string pointer, std::string message,
           std::string advice);
  /// The worst first; within a severity in the order in which they were found.
  [[nodiscard]] std::vector<Finding> sorted() const;

 private:
  std::vector<Finding> findings_;
};

}  // namespace lume::io::check
