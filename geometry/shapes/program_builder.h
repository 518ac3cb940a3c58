// SPDX-License-Identifier: Apache-2.0
// Writes the program of a formula, shorter where the formula allows it: constants are folded, and
// products of a term with itself become squares, which are never negative for intervals either.
#pragma once

#include "geometry/shapes/expression.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace lume::geometry {

class ProgramBuilder {
 public:
  /// Where the next operand will begin.
  [[nodiscard]] std::size_t size() const { return program_.size(); }
  [[nodiscard]] std::vector<Operation> take() { return std::move(program_); }

  void push(Operation::Code variable) { program_.push_back({.code = variable}); }
  void push(double constant) { program_.push_back({.value = constant}); }
  /// Applies a function of one argument to the operand that begins at `first`.
  void unary(Operation::Code code, std::size_t first);
  /// Combines the operands that begin at `first` and at `second`.
  void binary(Operation::Code code, std::size_t first, std::size_t second);

 private:
  /// The constant that the operand from `begin` to `end` consists of, if it does.
  [[nodiscard]] const double* constant(std::size_t begin, std::size_t end) const;
  void replace(std::size_t first, double value);
  bool fold(Operation::Code code, std::size_t first, std::size_t second);
  bool combine_with_constant(Operation::Code code, std::size_t first, std::size_t second);
  bool raise_to_constant(std::size_t second);
  [[nodiscard]] bool are_equal(std::size_t first, std::size_t second) const;

  std::vector<Operation> program_;
};

}  // namespace lume::geometry
