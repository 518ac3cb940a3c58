// SPDX-License-Identifier: Apache-2.0
#include "renderer/cli/svg_writer.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace lume::cli {
namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Invalid UTF-8 as the replacement character; the JSON library can tell.
std::string valid_utf8(std::string_view text) {
  const nlohmann::json json = std::string(text);
  const auto replace = nlohmann::json::error_handler_t::replace;
  return nlohmann::json::parse(json.dump(-1, ' ', false, replace)).get<std::string>();
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  const std::string valid = valid_utf8(text);
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const char c = valid[i];
    const std::string_view three = std::string_view(valid).substr(i, 3);
    if (three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF") {  // U+FFFE, U+FFFF
      result += '?';
      i += 2;
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

std::size_t count_characters(std::string_view text) {
  return text.size() -
         static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

std::string shorten(std::string_view text, std::size_t most) {
  if (count_characters(text) <= most) return std::string(text);
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end) {
    if (!continues_character(text[end]) && ++seen == most) break;
  }
  return std::string(text.substr(0, end)) + "…";
}

void SvgWriter::line(const SvgPoint& from, const SvgPoint& to, std::string_view style) {
  body_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)", from.x,
                       from.y, to.x, to.y, style) +
           "\n";
}

void SvgWriter::circle(const SvgPoint& center, double radius, std::string_view style) {
  body_ += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" {}/>)", center.x, center.y,
                       radius, style) +
           "\n";
}

void SvgWriter::rectangle(const SvgPoint& corner, double width, double height,
                          std::string_view style) {
  body_ += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" {}/>)",
                       corner.x, corner.y, width, height, style) +
           "\n";
}

void SvgWriter::path(std::string_view data, std::string_view style) {
  body_ += fmt::format("<path d=\"{}\" {}/>\n", data, style);
}

void SvgWriter::text(const SvgPoint& start, std::string_view content, std::string_view style) {
  body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", start.x, start.y, style,
                       xml_text(content));
}

void SvgWriter::formula(const SvgPoint& start, std::string_view content, std::string_view style) {
  std::string inner;
  for (std::size_t i = 0; i < content.size();) {
    const bool lowered = content[i] == '_';
    if (!lowered && content[i] != '^') {
      inner += xml_text(content.substr(i, 1));
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < content.size() && std::isalnum(static_cast<unsigned char>(content[end])) != 0)
      ++end;
    const int shift = lowered ? 3 : -4;
    inner +=
        fmt::format(R"(<tspan dy="{}" font-size="75%">{}</tspan><tspan dy="{}">&#8203;</tspan>)",
                    shift, content.substr(i + 1, end - i - 1), -shift);
    i = end;
  }
  body_ +=
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", start.x, start.y, style, inner);
}

void SvgWriter::arrow_head(const SvgPoint& from, const SvgPoint& tip, std::string_view style) {
  const double length = std::hypot(tip.x - from.x, tip.y - from.y);
  if (!(length > 0.0)) return;
  const SvgPoint along{(tip.x - from.x) / length, (tip.y - from.y) / length};
  const SvgPoint base{tip.x - 8.0 * along.x, tip.y - 8.0 * along.y};
  path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z", tip.x, tip.y,
                   base.x - 3.5 * along.y, base.y + 3.5 * along.x, base.x + 3.5 * along.y,
                   base.y - 3.5 * along.x),
       style);
}

std::string SvgWriter::finish(double width, double height, std::string_view title) const {
  return fmt::format(
             R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}" font-family="'DejaVu Sans', Verdana, Arial, sans-serif" font-size="9" fill="#222">
<title>{2}</title>
<rect width="100%" height="100%" fill="#fff"/>
)",
             width, height, xml_text(title)) +
         body_ + "</svg>\n";
}

std::string SvgWriter::inline_element(double width, double height, std::string_view title) const {
  return fmt::format(
             R"(<svg width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}" role="img">
<title>{2}</title>
)",
             width, height, xml_text(title)) +
         body_ + "</svg>\n";
}

}  // namespace lume::cli
