// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace lume::io::gltf {

/// Collects what was left out or repaired. The same thing said of many subjects becomes one line:
/// "mesh 3 primitive 0 and 41 more: lines are not drawn".
class Notes {
 public:
  void add(const std::string& subject, const std::string& text);
  /// In the order in which they were first said.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  struct Note {
    std::string subject;
    std::string text;
    std::size_t count = 0;
  };
  std::vector<Note> notes_;
  std::map<std::string, std::size_t> by_text_;
};

}  // namespace lume::io::gltf
