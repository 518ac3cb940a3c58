// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/expression_parser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <system_error>

namespace lume::geometry {
namespace {

using Code = Operation::Code;

struct Function {
  std::string_view name;
  Code code;
};
constexpr std::array<Function, 10> k_functions = {{{"sqrt", Code::sqrt},
                                                   {"abs", Code::abs},
                                                   {"exp", Code::exp},
                                                   {"log", Code::log},
                                                   {"sin", Code::sin},
                                                   {"cos", Code::cos},
                                                   {"tan", Code::tan},
                                                   {"atan", Code::atan},
                                                   {"min", Code::min},
                                                   {"max", Code::max}}};

// Not the C library's, which follow the locale.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// As much of a name as an error message should repeat.
std::string quoted(std::string_view name) {
  constexpr std::size_t k_longest = 24;
  std::string text(1, '"');
  text += name.substr(0, k_longest);
  text += name.size() > k_longest ? "...\"" : "\"";
  return text;
}

}  // namespace

std::vector<Operation> ExpressionParser::parse() {
  sum();
  if (peek() == ')') fail("there is no \"(\" that this \")\" closes");
  skip_spaces();
  if (position_ < text_.size()) fail_unexpected("an operator (+ - * / ^) or the end");
  return builder_.take();
}

void ExpressionParser::sum() {
  if (++depth_ > Expression::k_max_nesting) {
    fail("nested more than " + std::to_string(Expression::k_max_nesting) + " levels deep");
  }
  const std::size_t first = builder_.size();
  product();
  while (peek() == '+' || peek() == '-') {
    const Code code = accept('+') ? Code::add : Code::subtract;
    if (code == Code::subtract) ++position_;
    const std::size_t second = builder_.size();
    product();
    binary(code, first, second);
  }
  --depth_;
}

void ExpressionParser::product() {
  const std::size_t first = builder_.size();
  signed_power();
  while (peek() == '*' || peek() == '/') {
    const Code code = accept('*') ? Code::multiply : Code::divide;
    if (code == Code::divide) ++position_;
    const std::size_t second = builder_.size();
    signed_power();
    binary(code, first, second);
  }
}

void ExpressionParser::signed_power() {
  bool negative = false;
  while (peek() == '+' || peek() == '-') {
    if (!accept('+')) {
      ++position_;
      negative = !negative;
    }
  }
  const std::size_t first = builder_.size();
  power();
  if (negative) unary(Code::negate, first);
}

void ExpressionParser::power() {
  const std::size_t first = builder_.size();
  primary();
  if (!accept('^')) return;
  if (++depth_ > Expression::k_max_nesting) {
    fail("more than " + std::to_string(Expression::k_max_nesting) + " powers of powers");
  }
  const std::size_t second = builder_.size();
  signed_power();
  binary(Code::power, first, second);
  --depth_;
}

void ExpressionParser::primary() {
  const char c = peek();
  if (is_digit(c) || c == '.') {
    number();
  } else if (is_letter(c)) {
    name();
  } else if (accept('(')) {
    sum();
    if (!accept(')')) fail_unexpected("\")\"");
  } else {
    fail_unexpected("a number, a name or \"(\"");
  }
}

void ExpressionParser::number() {
  double value = 0.0;
  const char* const begin = text_.data() + position_;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
  if (error == std::errc::invalid_argument) fail("expected digits beside the decimal point");
  if (error != std::errc()) fail("the number is too large or too small for a double");
  position_ += static_cast<std::size_t>(end - begin);
  builder_.push(value);
  check_length();
}

void ExpressionParser::name() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && (is_letter(text_[position_]) || is_digit(text_[position_]))) {
    ++position_;
  }
  const std::string_view found = text_.substr(begin, position_ - begin);
  for (const Function& function : k_functions) {
    if (function.name == found) {
      call(function.code, begin, found);
      return;
    }
  }
  if (found == "x") {
    builder_.push(Code::x);
  } else if (found == "y") {
    builder_.push(Code::y);
  } else if (found == "z") {
    builder_.push(Code::z);
  } else if (found == "pi") {
    builder_.push(std::numbers::pi);
  } else if (found == "e") {
    builder_.push(std::numbers::e);
  } else {
    position_ = begin;
    fail("unknown name " + quoted(found) +
         "; known are x y z pi e sqrt abs exp log sin cos tan atan min max");
  }
  check_length();
}

void ExpressionParser::call(Code code, std::size_t begin, std::string_view called) {
  if (!accept('(')) fail_unexpected("\"(\" after the function " + quoted(called));
  const std::size_t first = builder_.size();
  std::size_t second = first;
  int count = 1;
  sum();
  while (accept(',')) {
    second = builder_.size();
    sum();
    ++count;
  }
  if (!accept(')')) fail_unexpected("\",\" or \")\"");
  const int wanted = operand_count(code);
  if (count != wanted) {
    position_ = begin;
    fail("the function " + quoted(called) + " takes " + std::to_string(wanted) +
         (wanted == 1 ? " argument" : " arguments") + ", not " + std::to_string(count));
  }
  if (wanted == 1) {
    unary(code, first);
  } else {
    binary(code, first, second);
  }
}

void ExpressionParser::binary(Code code, std::size_t first, std::size_t second) {
  builder_.binary(code, first, second);
  check_length();
}

void ExpressionParser::unary(Code code, std::size_t first) {
  builder_.unary(code, first);
  check_length();
}

void ExpressionParser::check_length() const {
  if (builder_.size() > Expression::k_max_operations) {
    fail("more than " + std::to_string(Expression::k_max_operations) + " operations");
  }
}

void ExpressionParser::skip_spaces() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

char ExpressionParser::peek() {
  skip_spaces();
  return position_ < text_.size() ? text_[position_] : '\0';
}

bool ExpressionParser::accept(char wanted) {
  if (peek() != wanted) return false;
  ++position_;
  return true;
}

void ExpressionParser::fail(const std::string& reason) const {
  throw ExpressionError(std::min(position_, text_.size()), reason);
}

void ExpressionParser::fail_unexpected(const std::string& expected) {
  const char c = peek();
  if (position_ >= text_.size()) fail("the formula ends where " + expected + " is expected");
  const bool is_printable = c > ' ' && c <= '~';
  const std::string found = is_printable ? quoted({&c, 1}) : "a character outside of ASCII";
  fail("expected " + expected + ", found " + found);
}

}  // namespace lume::geometry
