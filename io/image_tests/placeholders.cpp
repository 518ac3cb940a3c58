// SPDX-License-Identifier: Apache-2.0
#include "io/image_tests/placeholders.h"

#include <fnmatch.h>
#include <glob.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <stdexcept>

namespace lume::io {
namespace {

/// Calls text(piece) and variable(name) for the parts of "piece${name}piece".
void split_environment(std::string_view text, const std::function<void(std::string_view)>& piece,
                       const std::function<void(const std::string&)>& variable) {
  while (true) {
    const std::size_t begin = text.find("${");
    piece(text.substr(0, begin));
    if (begin == std::string_view::npos) return;
    const std::size_t end = text.find('}', begin);
    if (end == std::string_view::npos) throw std::invalid_argument("'${' without a '}'");
    variable(std::string(text.substr(begin + 2, end - begin - 2)));
    text.remove_prefix(end + 1);
  }
}

/// The text as a pattern that stands for nothing but itself.
std::string without_globs(std::string_view text) {
  std::string pattern;
  for (const char c : text) {
    if (std::string_view("*?[]{},\\").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern;
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = '\0';
  for (const char c : text) {
    const bool is_space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (quote == '\0' && is_space) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (quote == '\0' && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = '\0';
    } else {
      words.back() += c;
    }
  }
  if (quote != '\0') throw std::invalid_argument("a quote does not end");
  return words;
}

std::string fill_placeholders(std::string text,
                              const std::vector<std::pair<std::string, std::string>>& values) {
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at)) {
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    const std::string_view key = std::string_view(text).substr(at + 1, end - at - 1);
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const auto& value) { return value.first == key; });
    if (found == values.end()) {
      ++at;
      continue;
    }
    text.replace(at, end - at + 1, found->second);
    at += found->second.size();  // what was put in is not looked at again
  }
  return text;
}

std::vector<std::string> environment_names(std::string_view text) {
  std::vector<std::string> names;
  split_environment(
      text, [](std::string_view) {}, [&](const std::string& name) { names.push_back(name); });
  return names;
}

std::string fill_environment(std::string_view text) {
  std::string filled;
  split_environment(
      text, [&](std::string_view piece) { filled += piece; },
      [&](const std::string& name) {
        const char* value = std::getenv(name.c_str());
        if (value != nullptr) filled += value;
      });
  return filled;
}

bool has_environment(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value != nullptr && *value != '\0';
}

bool is_glob(std::string_view text) { return text.find_first_of("*?[{") != std::string_view::npos; }

std::vector<std::filesystem::path> glob_files(const std::filesystem::path& folder,
                                              const std::string& pattern) {
  const std::filesystem::path whole =
      std::filesystem::path(without_globs(folder.string())) / pattern;
  glob_t found{};
  std::vector<std::filesystem::path> files;
  if (glob(whole.c_str(), GLOB_BRACE | GLOB_NOSORT, nullptr, &found) == 0) {
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  // {a,b} may name a file twice.
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

bool glob_matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

}  // namespace lume::io
