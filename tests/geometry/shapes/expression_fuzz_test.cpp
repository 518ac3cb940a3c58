// SPDX-License-Identifier: Apache-2.0
// Random formulas and random text: what is accepted must be evaluated soundly.
#include "geometry/shapes/expression.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace lume::geometry {
namespace {

using test::Random;

/// A random formula.
std::string any_term(Random& random, int depth) {
  static const std::array<std::string, 8> leaves = {"x", "y", "z", "2", "0.3", "pi", "-1.5", "e"};
  static const std::array<std::string, 8> calls = {"sqrt", "abs", "exp", "log",
                                                   "sin",  "cos", "tan", "atan"};
  if (depth == 0 || random.below(5) == 0) return leaves[random.below(8)];
  const std::string a = any_term(random, depth - 1);
  switch (random.below(6)) {
    case 0:
      return calls[random.below(8)] + "(" + a + ")";
    case 1:
      return (random.below(2) == 0 ? "min(" : "max(") + a + "," + any_term(random, depth - 1) + ")";
    case 2:
      return "(" + a + ")^" + std::to_string(static_cast<int>(random.below(8)) - 3);
    case 3:
      return "(" + a + ")^(" + any_term(random, depth - 1) + ")";
    default:
      break;
  }
  static const std::array<std::string, 4> operators = {"+", "-", "*", "/"};
  return "(" + a + operators[random.below(4)] + any_term(random, depth - 1) + ")";
}

/// What the formula and its slope are at a point is in what they are for a box around it.
void expect_inclusion(const Expression& f, Random& random, const std::string& text) {
  const DVec3 lower(random.cube(2.0f));
  const DVec3 size = DVec3(random.cube(0.5f)) + 0.5;
  const DVec3 p = lower + size * (0.5 + DVec3(random.cube(0.5f)));
  using Number = Dual<Interval, 1>;
  const auto whole = f.evaluate(Number(Interval(lower.x, lower.x + size.x), {Interval(1.0)}),
                                Number(Interval(lower.y, lower.y + size.y), {Interval(-2.0)}),
                                Number(Interval(lower.z, lower.z + size.z), {Interval(0.5)}));
  const auto at_point = f.with_gradient(p.x, p.y, p.z);
  if (!std::isfinite(at_point.value)) return;
  if (whole.value.is_empty()) {  // 1 / (1 / 0) is 0 for doubles and nothing for intervals
    EXPECT_NE(text.find_first_of("/^"), std::string::npos) << text;
    return;
  }
  EXPECT_TRUE(whole.value.contains(at_point.value)) << text;
  const double slope = at_point.slope[0] - 2.0 * at_point.slope[1] + 0.5 * at_point.slope[2];
  if (!std::isfinite(slope)) return;
  const double error = 1e-9 * (1.0 + std::abs(at_point.slope[0]) + std::abs(at_point.slope[1]) +
                               std::abs(at_point.slope[2]));
  EXPECT_TRUE(whole.slope[0].lower <= slope + error && whole.slope[0].upper >= slope - error)
      << text << ": " << slope << " not in [" << whole.slope[0].lower << ", "
      << whole.slope[0].upper << "]";
}

TEST(Expression, RandomFormulas_IntervalsHoldValuesAndSlopes) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const std::string text = any_term(random, 3);
    expect_inclusion(Expression(text), random, text);
  }
}

TEST(Expression, RandomBytes_AreReadOrRefused) {
  Random random(5);
  const std::string alphabet = "xyze+-*/^(),.0123456789 sincotaqrbplgm";
  int accepted = 0;
  for (int i = 0; i < 50000; ++i) {
    std::string text(random.below(24), ' ');
    for (char& c : text) {
      c = i % 2 == 0 ? alphabet[random.below(static_cast<std::uint32_t>(alphabet.size()))]
                     : static_cast<char>(random.below(256));
    }
    try {
      const Expression f(text);
      ++accepted;
      expect_inclusion(f, random, text);
    } catch (const ExpressionError& error) {
      EXPECT_LE(error.position(), text.size());
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(accepted, 100);
}

TEST(Expression, MutatedFormulas_AreReadOrRefused) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    std::string text = any_term(random, 4);
    const auto size = static_cast<std::uint32_t>(text.size());
    switch (random.below(3)) {
      case 0:
        text.erase(random.below(size), 1 + random.below(3));
        break;
      case 1:
        text.insert(random.below(size), text.substr(random.below(size), 3));
        break;
      default:
        text[random.below(size)] = static_cast<char>(random.below(128));
        break;
    }
    try {
      const Expression f(text);
      expect_inclusion(f, random, text);
    } catch (const ExpressionError& error) {
      EXPECT_LE(error.position(), text.size());
    }
  }
}

}  // namespace
}  // namespace lume::geometry
