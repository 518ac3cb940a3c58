// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lume::io {

/// A message of a library, which may have several lines, as one line without an end.
[[nodiscard]] inline std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace lume::io
