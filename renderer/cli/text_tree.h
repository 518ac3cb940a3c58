// SPDX-License-Identifier: Apache-2.0
// A tree drawn with characters.
#pragma once

#include <string>
#include <vector>

namespace lume::cli {

struct TextNode {
  std::vector<std::string> lines;  ///< at least one
  std::vector<TextNode> children;
};

/// Each node's lines one below the other, its children below them, joined by lines.
[[nodiscard]] inline std::string draw_tree(const TextNode& node, const std::string& first = "",
                                           const std::string& rest = "") {
  std::string text;
  for (std::size_t i = 0; i < node.lines.size(); ++i) {
    const char* stem = i == 0 ? "" : node.children.empty() ? "  " : "│ ";
    text += (i == 0 ? first : rest) + stem + node.lines[i] + "\n";
  }
  for (const TextNode& child : node.children) {
    const bool is_last = &child == &node.children.back();
    text += draw_tree(child, rest + (is_last ? "└ " : "├ "), rest + (is_last ? "  " : "│ "));
  }
  return text;
}

}  // namespace lume::cli
