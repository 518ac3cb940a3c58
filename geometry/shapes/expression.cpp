// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/expression.h"

#include "geometry/shapes/expression_parser.h"

#include <algorithm>

namespace lume::geometry {
namespace {

/// The entries that a program needs on the stack.
int stack_need(const std::vector<Operation>& program) {
  int entries = 0;
  int most = 0;
  for (const Operation& operation : program) {
    entries += 1 - operand_count(operation.code);
    most = std::max(most, entries);
  }
  return most;
}

}  // namespace

Expression::Expression(std::string_view text) {
  if (text.size() > k_max_characters) {
    throw ExpressionError(k_max_characters, "longer than " + std::to_string(k_max_characters) +
                                                " characters, the most that a formula may have");
  }
  program_ = ExpressionParser(text).parse();
  if (stack_need(program_) > k_max_stack) {
    throw ExpressionError(
        0, "more than " + std::to_string(k_max_stack) + " intermediate results are open at once");
  }
}

}  // namespace lume::geometry
