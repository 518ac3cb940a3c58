// SPDX-License-Identifier: Apache-2.0
// Finds the roots of a function of one variable in order, none skipped, with interval arithmetic:
// Moore, Kearfott and Cloud 2009, "Introduction to Interval Analysis", chapter 8; for ray tracing
// Mitchell 1990, "Robust Ray Intersection with Interval Arithmetic".
#pragma once

#include "geometry/shapes/dual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace lume::geometry {

/// Function has the template `T operator()(const T& s)` for T = double, Interval,
/// Dual<double, 1> and Dual<Interval, 1>.
template <class Function>
class RootIsolator {
 public:
  explicit RootIsolator(const Function& function) : function_(function) {}

  /// The first root in [0, 1] of which accept(root) says true. A cell that skip(cell's ends) says
  /// true of is passed over unseen; nothing else that `accept` and `skip` do changes the roots.
  ///
  /// A root is where the function changes its sign and is continuous. Where it touches 0 without
  /// (a tangent) there is one only if its value there is 0 to rounding. A pole is none.
  template <class Accept, class Skip>
  std::optional<double> first(const Accept& accept, const Skip& skip) {
    size_ = 0;
    push(0.0, 1.0);
    for (int count = 0; size_ > 0; ++count) {
      const Cell cell = cells_[--size_];
      if (skip(cell.begin, cell.end)) continue;
      const auto root = examine(cell, count >= k_max_cells);
      if (root && accept(*root)) return root;
    }
    return std::nullopt;
  }

 private:
  // Halving makes cells as narrow as k_min_width on level 40 at the latest.
  static constexpr double k_min_width = 0x1p-40;
  static constexpr std::size_t k_max_levels = 64;
  // Formulas that a picture can be made of need some tens of cells; what is left after so many is
  // decided by the signs at its ends alone.
  static constexpr int k_max_cells = 20000;

  struct Cell {
    double begin;
    double end;
  };

  void push(double begin, double end) {
    if (begin < end) cells_[size_++] = {begin, end};
  }

  /// A root in the cell, if it can be decided now; else the cell's parts are put on the stack.
  std::optional<double> examine(const Cell& cell, bool is_last_chance) {
    const Interval s(cell.begin, cell.end);
    const auto f = function_(Dual<Interval, 1>(s, {Interval(1.0)}));
    if (!f.value.contains(0.0)) return std::nullopt;
    const Interval& slope = f.slope[0];
    // Monotone: one root at the most. A function with gaps or poles has no such slope or value.
    if ((slope.lower > 0.0 || slope.upper < 0.0) && f.value.is_bounded()) {
      const double at_begin = function_(cell.begin);
      const double at_end = function_(cell.end);
      if (!std::isnan(at_begin + at_end)) {
        if (!changes_sign(at_begin, at_end)) return std::nullopt;
        return polish(cell, at_begin);
      }
    }
    // The mean value theorem: f(s) lies in f(m) + f'(S) (s - m). Where that excludes 0 around m
    // there is nothing to look for. With f(m) > 0 a root behind m needs a falling f, one before m a
    // rising f; else the other way around.
    const double middle = 0.5 * (cell.begin + cell.end);
    const Interval at_middle = function_(Interval(middle));
    const bool is_positive = at_middle.lower > 0.0;
    const double least = is_positive ? at_middle.lower : -at_middle.upper;  // of |f(m)|
    const double left_end = middle - free_length(least, is_positive ? slope.upper : -slope.lower);
    const double right_begin =
        middle + free_length(least, is_positive ? -slope.lower : slope.upper);
    if (left_end < cell.begin && right_begin > cell.end) return std::nullopt;
    const double width = cell.end - cell.begin;
    const bool is_noise = slope.magnitude() * width <= 2.0 * at_middle.radius();
    if (is_noise || is_last_chance || width <= k_min_width || size_ + 2 > k_max_levels) {
      return decide(cell, f.value.is_bounded());
    }
    push(right_begin, cell.end);  // the nearer part comes off the stack first
    push(cell.begin, left_end);
    return std::nullopt;
  }

  /// How far |f|, now at least `value`, is from 0 if it falls no faster than `steepest`.
  static double free_length(double value, double steepest) {
    if (!(value > 0.0)) return 0.0;
    if (steepest <= 0.0) return std::numeric_limits<double>::infinity();
    const double length = value / steepest * (1.0 - 1e-12) - 0x1p-50;
    return length > 0.0 ? length : 0.0;  // NaN is 0, too
  }

  std::optional<double> decide(const Cell& cell, bool is_continuous) {
    const double at_begin = function_(cell.begin);
    const double at_end = function_(cell.end);
    const bool has_values = !std::isnan(at_begin + at_end);
    if (is_continuous && has_values && changes_sign(at_begin, at_end)) {
      return polish(cell, at_begin);
    }
    for (const double s : {cell.begin, 0.5 * (cell.begin + cell.end), cell.end}) {
      const Interval value = function_(Interval(s));
      if (value.contains(0.0) && value.is_bounded()) return s;  // 0 to rounding; not so at a pole
    }
    return std::nullopt;
  }

  /// 0 counts as positive, so that of two cells that share a root at their common end one has it.
  static bool is_negative(double value) { return value < 0.0; }
  static bool changes_sign(double a, double b) { return is_negative(a) != is_negative(b); }

  /// Newton's method within a bracket, which is halved where Newton would leave it or be slow.
  double polish(const Cell& cell, double at_begin) {
    double low = cell.begin;
    double high = cell.end;
    double s = 0.5 * (low + high);
    double last_step = high - low;
    for (int i = 0; i < 100; ++i) {
      const auto f = function_(Dual<double, 1>(s, {1.0}));
      (is_negative(f.value) == is_negative(at_begin) ? low : high) = s;
      double next = s - f.value / f.slope[0];
      // The ends themselves are welcome: the root may be one.
      if (!(next >= low && next <= high) || std::abs(next - s) > 0.5 * last_step) {
        next = 0.5 * (low + high);
      }
      last_step = std::abs(next - s);
      s = next;
      if (last_step <= 0x1p-52 * s + 0x1p-60) break;
    }
    return s;
  }

  const Function& function_;
  std::array<Cell, k_max_levels> cells_{};
  std::size_t size_ = 0;
};

}  // namespace lume::geometry
