// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace lume::io {

/// The exit codes of `lume` that stand for a failure to read or write.
enum class ErrorKind {
  scene = 3,         ///< the content of a scene file is wrong or not supported
  input_output = 4,  ///< a file cannot be read, decoded or written
};

/// Anything that is wrong with a file, said in one line: what, where in the file, what was
/// expected.
class Error : public std::runtime_error {
 public:
  /// `pointer` is a JSON pointer (RFC 6901) into the file, or empty.
  Error(ErrorKind kind, const std::string& path, const std::string& pointer,
        const std::string& reason)
      : std::runtime_error(path + (pointer.empty() ? "" : " at " + pointer) + ": " + reason),
        kind_(kind),
        path_(path),
        pointer_(pointer),
        reason_(reason) {}

  [[nodiscard]] ErrorKind kind() const { return kind_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  ErrorKind kind_;
  std::string path_;
  std::string pointer_;
  std::string reason_;
};

}  // namespace lume::io
