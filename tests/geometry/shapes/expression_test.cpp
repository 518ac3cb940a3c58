// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/expression.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace lume::geometry {
namespace {

using test::Random;

double value_of(const std::string& text, double x = 0.0, double y = 0.0, double z = 0.0) {
  return Expression(text).evaluate(x, y, z);
}

struct Fault {
  std::size_t position;
  std::string reason;
};
Fault fault_of(const std::string& text) {
  try {
    const Expression expression(text);
  } catch (const ExpressionError& error) {
    return {error.position(), error.what()};
  }
  ADD_FAILURE() << "accepted: " << text;
  return {0, ""};
}

TEST(Expression, Operators_BindAsInMathematics) {
  EXPECT_EQ(value_of("1 + 2 * 3"), 7.0);
  EXPECT_EQ(value_of("8 - 3 - 2"), 3.0);
  EXPECT_EQ(value_of("16 / 4 / 2"), 2.0);
  EXPECT_EQ(value_of("2 ^ 3 ^ 2"), 512.0);
  EXPECT_EQ(value_of("-3 ^ 2"), -9.0);
  EXPECT_EQ(value_of("-x ^ 2", 3.0), -9.0);
  EXPECT_EQ(value_of("(-x) ^ 2", 3.0), 9.0);
  EXPECT_EQ(value_of("2 ^ -2"), 0.25);
  EXPECT_EQ(value_of("x ^ -y ^ 2", 2.0, 2.0), 0.0625);
  EXPECT_EQ(value_of("--3"), 3.0);
  EXPECT_EQ(value_of("+-+3"), -3.0);
  EXPECT_EQ(value_of("2 * -x", 3.0), -6.0);
  EXPECT_EQ(value_of("x - -y", 3.0, 4.0), 7.0);
  EXPECT_EQ(value_of("(1 + x) * (1 - x)", 3.0), -8.0);
  EXPECT_EQ(value_of("5 - x", 3.0), 2.0);
  EXPECT_EQ(value_of("x - 5", 3.0), -2.0);
  EXPECT_EQ(value_of("6 / x", 3.0), 2.0);
  EXPECT_EQ(value_of("x / 6", 3.0), 0.5);
  EXPECT_EQ(value_of(" \t1\n+\r2 "), 3.0);
}

TEST(Expression, NumbersAndConstants_AreRead) {
  EXPECT_EQ(value_of("0.5"), 0.5);
  EXPECT_EQ(value_of(".5"), 0.5);
  EXPECT_EQ(value_of("5."), 5.0);
  EXPECT_EQ(value_of("1.5e3"), 1500.0);
  EXPECT_EQ(value_of("1E-2"), 0.01);
  EXPECT_EQ(value_of("pi"), std::numbers::pi);
  EXPECT_EQ(value_of("e"), std::numbers::e);
  EXPECT_EQ(value_of("x + 10*y + 100*z", 1.0, 2.0, 3.0), 321.0);
}

TEST(Expression, Functions_AreThoseOfTheLibrary) {
  EXPECT_EQ(value_of("sqrt(x)", 2.0), std::sqrt(2.0));
  EXPECT_EQ(value_of("abs(x)", -2.0), 2.0);
  EXPECT_EQ(value_of("exp(x)", 2.0), std::exp(2.0));
  EXPECT_EQ(value_of("log(x)", 2.0), std::log(2.0));
  EXPECT_EQ(value_of("sin(x)", 2.0), std::sin(2.0));
  EXPECT_EQ(value_of("cos(x)", 2.0), std::cos(2.0));
  EXPECT_EQ(value_of("tan(x)", 2.0), std::tan(2.0));
  EXPECT_EQ(value_of("atan(x)", 2.0), std::atan(2.0));
  EXPECT_EQ(value_of("min(x, y)", 2.0, 3.0), 2.0);
  EXPECT_EQ(value_of("max(x, y)", 2.0, 3.0), 3.0);
  EXPECT_EQ(value_of("max(min(x, y), 2.5)", 2.0, 3.0), 2.5);
}

TEST(Expression, Powers_OfNegativeBasesNeedWholeExponents) {
  EXPECT_EQ(value_of("x ^ 3", -2.0), -8.0);
  EXPECT_EQ(value_of("x ^ -1", -2.0), -0.5);
  EXPECT_EQ(value_of("x ^ 0", -2.0), 1.0);
  EXPECT_EQ(value_of("x ^ (1 + 1)", -3.0), 9.0);
  EXPECT_EQ(value_of("(-2) ^ 3"), -8.0);
  EXPECT_EQ(value_of("x ^ 0.5", 4.0), 2.0);
  EXPECT_EQ(value_of("x ^ (1 / 2)", 4.0), 2.0);
  EXPECT_TRUE(std::isnan(value_of("x ^ 0.5", -4.0)));
  EXPECT_TRUE(std::isnan(value_of("x ^ y", -2.0, 2.0)));
  EXPECT_NEAR(value_of("x ^ 1024", 1.001), std::pow(1.001, 1024), 1e-12);
}

TEST(Expression, NoValue_IsNotANumber) {
  EXPECT_TRUE(std::isnan(value_of("sqrt(x)", -1.0)));
  EXPECT_TRUE(std::isnan(value_of("min(sqrt(x), 1)", -1.0)));
  EXPECT_TRUE(std::isnan(value_of("max(1, sqrt(x))", -1.0)));
  EXPECT_TRUE(std::isnan(value_of("0 / 0")));
  EXPECT_TRUE(std::isnan(value_of("log(-1)")));
}

TEST(Expression, FaultyText_IsReportedWithItsPlace) {
  struct Case {
    std::string text;
    std::size_t position;
    std::string reason;
  };
  const std::array cases = {
      Case{"", 0, "the formula ends where a number, a name or \"(\" is expected"},
      Case{"   ", 3, "the formula ends where a number, a name or \"(\" is expected"},
      Case{"1 +", 3, "the formula ends where a number, a name or \"(\" is expected"},
      Case{"1 + * 2", 4, R"(expected a number, a name or "(", found "*")"},
      Case{"(x + 1", 6, "the formula ends where \")\" is expected"},
      Case{"(x + 1]", 6, "expected \")\", found \"]\""},
      Case{"x)", 1, "there is no \"(\" that this \")\" closes"},
      Case{"2x", 1, "expected an operator (+ - * / ^) or the end, found \"x\""},
      Case{"x y", 2, "expected an operator (+ - * / ^) or the end, found \"y\""},
      Case{"x = 0", 2, "expected an operator (+ - * / ^) or the end, found \"=\""},
      Case{"x, y", 1, "expected an operator (+ - * / ^) or the end, found \",\""},
      Case{"2 + foo", 4,
           "unknown name \"foo\"; known are x y z pi e sqrt abs exp log sin cos tan atan min max"},
      Case{"X", 0,
           "unknown name \"X\"; known are x y z pi e sqrt abs exp log sin cos tan atan min max"},
      Case{"sin x", 4, R"(expected "(" after the function "sin", found "x")"},
      Case{"sin", 3, R"(the formula ends where "(" after the function "sin" is expected)"},
      Case{"1+sin(x, y)", 2, "the function \"sin\" takes 1 argument, not 2"},
      Case{"min(x)", 0, "the function \"min\" takes 2 arguments, not 1"},
      Case{"max(x, y, z)", 0, "the function \"max\" takes 2 arguments, not 3"},
      Case{"min(x; y)", 5, "expected \",\" or \")\", found \";\""},
      Case{"sqrt()", 5, "expected a number, a name or \"(\", found \")\""},
      Case{"1 + .", 4, "expected digits beside the decimal point"},
      Case{"1e999", 0, "the number is too large or too small for a double"},
      Case{"x + \xc3\xa9", 4,
           "expected a number, a name or \"(\", found a character outside of ASCII"},
      Case{std::string("x\0y", 3), 1,
           "expected an operator (+ - * / ^) or the end, found a character outside of ASCII"},
  };
  for (const Case& c : cases) {
    const Fault fault = fault_of(c.text);
    EXPECT_EQ(fault.position, c.position) << c.text;
    EXPECT_EQ(fault.reason, c.reason) << c.text;
  }
}

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

TEST(Expression, TextBeyondTheLimits_IsRefused) {
  EXPECT_EQ(fault_of(repeated("x+", 3000) + "x").reason,
            "longer than 4096 characters, the most that a formula may have");
  EXPECT_EQ(fault_of(repeated("x+", 1000) + "x").reason, "more than 1024 operations");
  EXPECT_EQ(fault_of(repeated("(", 1000) + "x").reason, "nested more than 64 levels deep");
  EXPECT_EQ(fault_of(repeated("sin(", 1000)).reason, "nested more than 64 levels deep");
  EXPECT_EQ(fault_of(repeated("x^", 1000) + "x").reason, "more than 64 powers of powers");
  EXPECT_EQ(fault_of(repeated("x*(", 50) + "x" + repeated(")", 50)).reason,
            "more than 32 intermediate results are open at once");
  EXPECT_LE(fault_of(repeated("a", 4000)).reason.size(), 120U);
  EXPECT_EQ(value_of(repeated("-", 4000) + "1"), 1.0);
  EXPECT_EQ(value_of(repeated("(", 60) + "x" + repeated(")", 60), 2.0), 2.0);
  EXPECT_EQ(value_of(repeated("x+", 500) + "x", 1.0), 501.0);
}

/// A formula beside its own derivatives, written by hand.
struct Known {
  std::string text;
  std::function<DVec3(double, double, double)> gradient;
};

TEST(Expression, Gradient_IsThatOfTheClosedForm) {
  const std::array known = {
      Known{"x*y*z", [](double x, double y, double z) { return DVec3(y * z, x * z, x * y); }},
      Known{"x/y - z", [](double x, double y, double) { return DVec3(1 / y, -x / (y * y), -1.0); }},
      Known{"3 - 2*x^3 + y^-2",
            [](double x, double y, double) { return DVec3(-6 * x * x, -2 / (y * y * y), 0.0); }},
      Known{"sqrt(x) + x^1.5",
            [](double x, double, double) {
              return DVec3(0.5 / std::sqrt(x) + 1.5 * std::sqrt(x), 0.0, 0.0);
            }},
      Known{"exp(x*y) + log(z)",
            [](double x, double y, double z) {
              return DVec3(y * std::exp(x * y), x * std::exp(x * y), 1 / z);
            }},
      Known{"sin(x)*cos(y)",
            [](double x, double y, double) {
              return DVec3(std::cos(x) * std::cos(y), -std::sin(x) * std::sin(y), 0.0);
            }},
      Known{"tan(x/9) + atan(y)",
            [](double x, double y, double) {
              return DVec3(1 / (9 * std::pow(std::cos(x / 9), 2)), 1 / (1 + y * y), 0.0);
            }},
      Known{"x^y",
            [](double x, double y, double) {
              return DVec3(y * std::pow(x, y - 1), std::log(x) * std::pow(x, y), 0.0);
            }},
      Known{"abs(x - y)",
            [](double x, double y, double) {
              return x > y ? DVec3(1.0, -1.0, 0.0) : DVec3(-1.0, 1.0, 0.0);
            }},
      Known{"min(x, 2*y) + max(y, z)",
            [](double x, double y, double z) {
              const DVec3 first = x < 2 * y ? DVec3(1.0, 0.0, 0.0) : DVec3(0.0, 2.0, 0.0);
              return first + (y > z ? DVec3(0.0, 1.0, 0.0) : DVec3(0.0, 0.0, 1.0));
            }},
  };
  Random random(3);
  for (const Known& k : known) {
    const Expression f(k.text);
    for (int i = 0; i < 1000; ++i) {
      const DVec3 p = DVec3(random.cube(1.4f)) + 1.5;
      const auto found = f.with_gradient(p.x, p.y, p.z);
      const DVec3 expected = k.gradient(p.x, p.y, p.z);
      EXPECT_EQ(found.value, f.evaluate(p.x, p.y, p.z));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double wanted = expected[static_cast<int>(axis)];
        EXPECT_NEAR(found.slope[axis], wanted, 1e-12 * (1.0 + std::abs(wanted))) << k.text;
      }
    }
  }
}

}  // namespace
}  // namespace lume::geometry
