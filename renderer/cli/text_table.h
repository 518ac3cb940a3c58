// SPDX-License-Identifier: Apache-2.0
// Tables as data, to be shown as text or as HTML.
#pragma once

#include <string>
#include <vector>

namespace lume::cli {

struct TextTable {
  std::string title;
  std::vector<std::string> header;  ///< a name, or words over each other with '\n' between them
  std::vector<std::vector<std::string>> rows;
};

/// Columns as wide as they need to be, the first one flush left, the others flush right.
[[nodiscard]] std::string draw_table(const TextTable& table);

/// The same as a <table>. Texts are escaped here.
[[nodiscard]] std::string html_table(const TextTable& table);

}  // namespace lume::cli
