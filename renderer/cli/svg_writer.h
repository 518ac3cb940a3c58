// SPDX-License-Identifier: Apache-2.0
// As much of SVG 1.1 as a diagram needs.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace lume::cli {

struct SvgPoint {
  double x = 0.0;
  double y = 0.0;
};

/// Valid UTF-8 of characters that XML 1.0 allows (section 2.2), with markup escaped.
[[nodiscard]] std::string xml_text(std::string_view text);

/// How many characters a UTF-8 text has.
[[nodiscard]] std::size_t count_characters(std::string_view text);
/// The text, or its beginning and an ellipsis, in at most `most` characters.
[[nodiscard]] std::string shorten(std::string_view text, std::size_t most);

/// Lengths are in pixels; styles are attributes, such as fill="none". Texts are escaped here.
class SvgWriter {
 public:
  void line(const SvgPoint& from, const SvgPoint& to, std::string_view style);
  void circle(const SvgPoint& center, double radius, std::string_view style);
  void rectangle(const SvgPoint& corner, double width, double height, std::string_view style);
  /// `data` as SVG has it: M, L, Q and so on.
  void path(std::string_view data, std::string_view style);
  void text(const SvgPoint& start, std::string_view content, std::string_view style);
  /// A text in which _x and ^x stand for x as subscript and superscript.
  void formula(const SvgPoint& start, std::string_view content, std::string_view style);
  /// The head of an arrow that ends at `tip`.
  void arrow_head(const SvgPoint& from, const SvgPoint& tip, std::string_view style);

  /// The whole file.
  [[nodiscard]] std::string finish(double width, double height, std::string_view title) const;
  /// The drawing as an element of an HTML page, whose fonts it takes.
  [[nodiscard]] std::string inline_element(double width, double height,
                                           std::string_view title) const;

 private:
  std::string body_;
};

}  // namespace lume::cli
