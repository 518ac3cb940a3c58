// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/text_table.h"

#include "renderer/cli/svg_writer.h"

#include <algorithm>
#include <sstream>

namespace lume::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The header as rows of its own, words at the bottom.
std::vector<std::vector<std::string>> header_rows(const TextTable& table) {
  std::vector<std::vector<std::string>> columns;
  columns.reserve(table.header.size());
  std::size_t height = 0;
  for (const std::string& cell : table.header) {
    columns.push_back(lines_of(cell));
    height = std::max(height, columns.back().size());
  }
  std::vector<std::vector<std::string>> rows(height);
  for (std::size_t row = 0; row < height; ++row) {
    for (const auto& lines : columns) {
      const std::size_t above = height - lines.size();
      rows[row].push_back(row < above ? "" : lines[row - above]);
    }
  }
  return rows;
}

std::string pad(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - std::min(width, count_characters(text)), ' ');
  return left ? text + space : space + text;
}

}  // namespace

std::string draw_table(const TextTable& table) {
  std::vector<std::vector<std::string>> rows = header_rows(table);
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  std::vector<std::size_t> widths(table.header.size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], count_characters(row[i]));
    }
  }
  std::string text = table.title + "\n";
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += "  " + pad(row[i], widths[i], i == 0);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string html_table(const TextTable& table) {
  std::string html = "<h3>" + xml_text(table.title) + "</h3>\n<table>\n<tr>";
  for (const std::string& cell : table.header) {
    std::string words;
    for (const std::string& line : lines_of(cell))
      words += (words.empty() ? "" : "<br>") + xml_text(line);
    html += "<th>" + words + "</th>";
  }
  html += "</tr>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& cell : row) html += "<td>" + xml_text(cell) + "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace lume::cli
