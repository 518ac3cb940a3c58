// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/program_builder.h"

#include <algorithm>
#include <cmath>

namespace lume::geometry {

using Code = Operation::Code;

const double* ProgramBuilder::constant(std::size_t begin, std::size_t end) const {
  return end == begin + 1 && program_[begin].code == Code::constant ? &program_[begin].value
                                                                    : nullptr;
}

void ProgramBuilder::replace(std::size_t first, double value) {
  program_.resize(first);
  push(value);
}

void ProgramBuilder::unary(Code code, std::size_t first) {
  if (const double* a = constant(first, size())) {
    double value = *a;
    apply_unary({.code = code}, value);
    if (std::isfinite(value)) {
      replace(first, value);
      return;
    }
  }
  push(code);
}

void ProgramBuilder::binary(Code code, std::size_t first, std::size_t second) {
  if (fold(code, first, second)) return;
  if (code == Code::power && raise_to_constant(second)) return;
  if (combine_with_constant(code, first, second)) return;
  if (code == Code::multiply && are_equal(first, second)) {
    program_.resize(second);
    program_.push_back({.code = Code::power_int, .exponent = 2});
    return;
  }
  push(code);
}

bool ProgramBuilder::fold(Code code, std::size_t first, std::size_t second) {
  const double* a = constant(first, second);
  const double* b = constant(second, size());
  if (a == nullptr || b == nullptr) return false;
  double value = *a;
  const bool is_whole = std::abs(*b) <= Expression::k_max_exponent && std::trunc(*b) == *b;
  if (code == Code::power && is_whole) {
    value = power(*a, static_cast<int>(*b));  // a negative base may have a whole power
  } else {
    apply_binary(code, value, *b);
  }
  if (!std::isfinite(value)) return false;
  replace(first, value);
  return true;
}

/// A difference is the sum with the opposite, c * x is x * c, and c + x is x + c. The quotient by a
/// constant stays: its inverse may not be exact.
bool ProgramBuilder::combine_with_constant(Code code, std::size_t first, std::size_t second) {
  if (code != Code::add && code != Code::subtract && code != Code::multiply) return false;
  const double* left = constant(first, second);
  const double* right = constant(second, size());
  if (left == nullptr && right == nullptr) return false;
  double value = left != nullptr ? *left : *right;
  if (left != nullptr) {
    program_.erase(program_.begin() + static_cast<std::ptrdiff_t>(first));
    if (code == Code::subtract) push(Code::negate);
  } else {
    program_.pop_back();
    if (code == Code::subtract) value = -value;
  }
  const bool is_product = code == Code::multiply;
  program_.push_back(
      {.code = is_product ? Code::multiply_constant : Code::add_constant, .value = value});
  return true;
}

bool ProgramBuilder::raise_to_constant(std::size_t second) {
  const double* exponent = constant(second, size());
  if (exponent == nullptr) return false;
  const double value = *exponent;
  program_.pop_back();
  if (std::abs(value) <= Expression::k_max_exponent && std::trunc(value) == value) {
    program_.push_back({.code = Code::power_int, .exponent = static_cast<int>(value)});
  } else {
    program_.push_back({.code = Code::power_real, .value = value});
  }
  return true;
}

bool ProgramBuilder::are_equal(std::size_t first, std::size_t second) const {
  if (second - first != size() - second) return false;
  const auto at = [this](std::size_t i) {
    return program_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return std::equal(at(first), at(second), at(second));
}

}  // namespace lume::geometry
