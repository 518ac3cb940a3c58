// SPDX-License-Identifier: Apache-2.0
// A formula in x, y and z, read from text once and evaluated for any kind of number: doubles,
// intervals, and numbers that carry derivatives (automatic differentiation).
#pragma once

#include "geometry/shapes/dual.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lume::geometry {

/// What is wrong with a formula, and where in its text (0 is the first character).
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(std::size_t position, const std::string& reason)
      : std::runtime_error(reason), position_(position) {}
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

/// One step of a compiled formula: it takes its operands from the stack and puts its result there.
struct Operation {
  enum class Code : std::uint8_t {
    constant,
    x,
    y,
    z,  // no operand
    negate,
    add_constant,
    multiply_constant,
    power_int,
    power_real,  // one
    sqrt,
    abs,
    exp,
    log,
    sin,
    cos,
    tan,
    atan,  // one
    add,
    subtract,
    multiply,
    divide,
    power,
    min,
    max,  // two
  };
  Code code = Code::constant;
  int exponent = 0;    // of power_int
  double value = 0.0;  // of constant, add_constant, multiply_constant and power_real

  friend bool operator==(const Operation& a, const Operation& b) = default;
};

/// The operands that a step takes from the stack.
[[nodiscard]] constexpr int operand_count(Operation::Code code) {
  if (code <= Operation::Code::z) return 0;
  return code <= Operation::Code::atan ? 1 : 2;
}

/// A formula as a program for a stack machine.
class Expression {
 public:
  static constexpr std::size_t k_max_characters = 4096;
  static constexpr std::size_t k_max_operations = 1024;
  static constexpr int k_max_nesting = 64;
  static constexpr int k_max_stack = 32;
  static constexpr int k_max_exponent = 1024;  // of the powers that are repeated products

  /// Reads numbers, x, y, z, the constants pi and e, + - * / ^, parentheses and the functions sqrt
  /// abs exp log sin cos tan atan (of one argument) min max (of two). ^ binds tightest and from
  /// right to left: -x^2^3 is -(x^(2^3)). A base to a power that is not a whole constant must be
  /// positive. Throws ExpressionError.
  explicit Expression(std::string_view text);

  /// NaN, or an empty interval, where the formula has no value. T is double, Interval or a Dual of
  /// these.
  template <class T>
  [[nodiscard]] T evaluate(const T& x, const T& y, const T& z) const;
  /// The value and its derivatives along x, y and z.
  [[nodiscard]] Dual<double, 3> with_gradient(double x, double y, double z) const {
    using Number = Dual<double, 3>;
    return evaluate(Number(x, {1.0, 0.0, 0.0}), Number(y, {0.0, 1.0, 0.0}),
                    Number(z, {0.0, 0.0, 1.0}));
  }

 private:
  std::vector<Operation> program_;
};

/// Carries out a step with one operand, in place.
template <class T>
inline void apply_unary(const Operation& operation, T& a) {
  using std::abs, std::atan, std::cos, std::exp, std::log, std::sin, std::sqrt, std::tan;
  switch (operation.code) {
    case Operation::Code::negate:
      a = -a;
      break;
    case Operation::Code::add_constant:
      a = a + operation.value;
      break;
    case Operation::Code::multiply_constant:
      a = a * operation.value;
      break;
    case Operation::Code::power_int:
      a = power(a, operation.exponent);
      break;
    case Operation::Code::power_real:
      a = power(a, operation.value);
      break;
    case Operation::Code::sqrt:
      a = sqrt(a);
      break;
    case Operation::Code::abs:
      a = abs(a);
      break;
    case Operation::Code::exp:
      a = exp(a);
      break;
    case Operation::Code::log:
      a = log(a);
      break;
    case Operation::Code::sin:
      a = sin(a);
      break;
    case Operation::Code::cos:
      a = cos(a);
      break;
    case Operation::Code::tan:
      a = tan(a);
      break;
    default:
      a = atan(a);
      break;
  }
}

/// Carries out a step with two operands; the first becomes the result.
template <class T>
inline void apply_binary(Operation::Code code, T& a, const T& b) {
  switch (code) {
    case Operation::Code::add:
      a = a + b;
      break;
    case Operation::Code::subtract:
      a = a - b;
      break;
    case Operation::Code::multiply:
      a = a * b;
      break;
    case Operation::Code::divide:
      a = a / b;
      break;
    case Operation::Code::power:
      a = power(a, b);
      break;
    case Operation::Code::min:
      a = minimum(a, b);
      break;
    default:
      a = maximum(a, b);
      break;
  }
}

template <class T>
T Expression::evaluate(const T& x, const T& y, const T& z) const {
  // Left as it is: clearing it would take longer than many a formula.
  std::array<T, k_max_stack> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  T* top = stack.data();             // one past the last entry
  for (const Operation& operation : program_) {
    switch (operation.code) {
      case Operation::Code::constant:
        *top++ = T(operation.value);
        break;
      case Operation::Code::x:
        *top++ = x;
        break;
      case Operation::Code::y:
        *top++ = y;
        break;
      case Operation::Code::z:
        *top++ = z;
        break;
      default:
        if (operand_count(operation.code) == 1) {
          apply_unary(operation, top[-1]);
        } else {
          --top;
          apply_binary(operation.code, top[-1], top[0]);
        }
    }
  }
  return top[-1];
}

}  // namespace lume::geometry
