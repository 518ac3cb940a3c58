// SPDX-License-Identifier: Apache-2.0
// Reads the text of a formula by recursive descent.
#pragma once

#include "geometry/shapes/program_builder.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lume::geometry {

/// The grammar, each rule a function; what is repeated is in braces, what is optional in brackets:
///   sum     = product { ("+" | "-") product }
///   product = signed { ("*" | "/") signed }
///   signed  = { "+" | "-" } power
///   power   = primary [ "^" signed ]
///   primary = number | name | name "(" sum { "," sum } ")" | "(" sum ")"
class ExpressionParser {
 public:
  /// `text` must outlive the parser.
  explicit ExpressionParser(std::string_view text) : text_(text) {}

  /// Throws ExpressionError.
  [[nodiscard]] std::vector<Operation> parse();

 private:
  void sum();
  void product();
  void signed_power();
  void power();
  void primary();
  void number();
  void name();
  void call(Operation::Code code, std::size_t begin, std::string_view called);

  void binary(Operation::Code code, std::size_t first, std::size_t second);
  void unary(Operation::Code code, std::size_t first);
  void check_length() const;
  void skip_spaces();
  /// The next character that is not a space; '\0' at the end.
  [[nodiscard]] char peek();
  [[nodiscard]] bool accept(char wanted);
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail_unexpected(const std::string& expected);

  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
  ProgramBuilder builder_;
};

}  // namespace lume::geometry
