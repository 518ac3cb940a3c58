// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/notes.h"

#include <fmt/format.h>

namespace lume::io::gltf {

void Notes::add(const std::string& subject, const std::string& text) {
  const auto [it, is_new] = by_text_.try_emplace(text, notes_.size());
  if (is_new) {
    notes_.push_back({subject, text, 0});
  }
  ++notes_[it->second].count;
}

std::vector<std::string> Notes::lines() const {
  std::vector<std::string> result;
  for (const Note& note : notes_) {
    result.push_back(note.count == 1 ? fmt::format("{}: {}", note.subject, note.text)
                                     : fmt::format("{} and {} more: {}", note.subject,
                                                   note.count - 1, note.text));
  }
  return result;
}

}  // namespace lume::io::gltf
