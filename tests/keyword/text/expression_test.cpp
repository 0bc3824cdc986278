#include "keyword/text/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace gapcheck::keyword::expression_test {
namespace {

Result<ExpressionNumber> names(std::string_view name) {
  if (name == "thk") return ExpressionNumber{1.5};
  if (name == "e") return ExpressionNumber{210000};
  if (name == "n") return ExpressionNumber{3, true};
  return Diagnostic{Severity::error, {}, 0, "unknown name"};
}

double value(const std::string& text) {
  const auto result = evaluate_expression(text, names);
  EXPECT_TRUE(result.ok()) << text << ": " << (result.ok() ? "" : result.error().message);
  return result.ok() ? result.value() : std::nan("");
}

std::string problem(const std::string& text) {
  const auto result = evaluate_expression(text, names);
  EXPECT_FALSE(result.ok()) << text;
  return result.ok() ? "" : result.error().message;
}

TEST(Expression, Precedence) {
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("2**3**2"), 512);
  EXPECT_EQ(value("-2**2"), -4);
  EXPECT_EQ(value("2**-1"), 0.5);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("7%4"), 3);
  EXPECT_EQ(value("10-2-3"), 5);
  EXPECT_EQ(value(" 1 +\t2 "), 3);
}

TEST(Expression, IntegersDivideAsSuch) {
  EXPECT_EQ(value("2/5"), 0);
  EXPECT_EQ(value("2.0/5"), 0.4);
  EXPECT_EQ(value("2/5."), 0.4);
  EXPECT_EQ(value("2e0/5"), 0.4);
  EXPECT_EQ(value("-7/2"), -3);
  EXPECT_EQ(value("(-7)/2"), -3);
  EXPECT_EQ(value("7/-2"), -3);
  EXPECT_EQ(value("1.0*n/2"), 1.5);
  EXPECT_EQ(value("n/2*1.0"), 1);
  EXPECT_EQ(value("e/n"), 70000);
  EXPECT_EQ(value("(n+1)/3"), 1);
  EXPECT_EQ(value("(n+1.)/8"), 0.5);
  EXPECT_EQ(value("n**2/2"), 4);
  EXPECT_EQ(value("max(n,4)/3"), 1);
  EXPECT_EQ(value("max(n,4.)/8"), 0.5);
  EXPECT_EQ(value("nint(2.6)/2"), 1);
  EXPECT_EQ(value("anint(2.6)/2"), 1.5);
  EXPECT_EQ(value("float(n)/2"), 1.5);
  EXPECT_EQ(value("abs(-n)/2+mod(7,4)/2+sign(n,-1)/2"), 1 + 1 - 1);
  EXPECT_EQ(value("sqrt(9)/2"), 1.5);
  EXPECT_EQ(value("9007199254740991/2"), 4503599627370495) << "without rounding up";
}

TEST(Expression, NumbersAndNames) {
  EXPECT_EQ(value("1.5e-3"), 0.0015);
  EXPECT_EQ(value("1.5D+2"), 150);
  EXPECT_EQ(value("1.5-3"), -1.5);
  EXPECT_EQ(value(".5+5."), 5.5);
  EXPECT_EQ(value("&thk*2"), 3);
  EXPECT_EQ(value("thk*2"), 3);
  EXPECT_EQ(value("e"), 210000);
  EXPECT_EQ(value("2*PI"), 2 * std::numbers::pi);
}

TEST(Expression, Functions) {
  EXPECT_EQ(value("max(1,2,3)-min(4,5)"), -1);
  EXPECT_EQ(value("mod(7,4)"), 3);
  EXPECT_EQ(value("sign(3,-2)"), -3);
  EXPECT_EQ(value("int(-2.7)"), -2);
  EXPECT_EQ(value("nint(2.5)"), 3);
  EXPECT_EQ(value("aint(2.7)+anint(2.7)+float(1)"), 6);
  EXPECT_NEAR(value("atan2(1,1)*4"), std::numbers::pi, 1e-15);
  EXPECT_NEAR(value("sin(0.3)**2+COS(0.3)**2"), 1, 1e-15);
  EXPECT_NEAR(value("csc(1)*sin(1)+sec(1)*cos(1)+ctn(1)*tan(1)"), 3, 1e-15);
  EXPECT_NEAR(value("asin(sin(.3))+acos(cos(.3))+atan(tan(.3))"), 0.9, 1e-14);
  EXPECT_NEAR(value("asinh(sinh(.3))+acosh(cosh(.3))+atanh(tanh(.3))"), 0.9, 1e-14);
  EXPECT_NEAR(value("log(exp(2))+log10(100)+sqrt(4)+abs(-1)"), 7, 1e-14);
}

TEST(Expression, FaultsSayWhatIsWrong) {
  EXPECT_NE(problem("1/0").find("divides by zero"), std::string::npos);
  EXPECT_NE(problem("7%0").find("divides by zero"), std::string::npos);
  EXPECT_NE(problem("sqrt(-1)").find("no finite value"), std::string::npos);
  EXPECT_NE(problem("10**400").find("no finite value"), std::string::npos);
  EXPECT_NE(problem("nothing+1").find("unknown name"), std::string::npos);
  EXPECT_NE(problem("foo(1)").find("unknown function"), std::string::npos);
  EXPECT_NE(problem("sin(1,2)").find("one argument"), std::string::npos);
  for (const char* text : {"", "(", "1+", "1 2", "1)", "sin(", "max()", "*2", "1..2", "#", "&"}) problem(text);
  problem(std::string("1\0+1", 4));
}

TEST(Expression, HostileDepthAndLength) {
  EXPECT_NE(problem(std::string(5000, '(') + "1").find("deep"), std::string::npos);
  EXPECT_NE(problem(std::string(5000, '-') + "1").find("deep"), std::string::npos);
  EXPECT_NE(problem(std::string(100000, '1')).find("longer"), std::string::npos);
  std::string powers = "1";
  for (int i = 0; i < 3000; ++i) powers += "**1";
  EXPECT_NE(problem(powers).find("deep"), std::string::npos);
  EXPECT_EQ(value("((((((((((1))))))))))"), 1);
}

/// A random expression together with its value, computed while it is written.
struct Written {
  std::string text;
  double value;
};

Written random_expression(std::mt19937& random, int depth) {
  const auto pick = random() % (depth == 0 ? 2 : 6);
  if (pick == 0) {
    const int n = static_cast<int>(random() % 100);
    return {std::to_string(n) + ".25", n + 0.25};
  }
  if (pick == 1) return {"thk", 1.5};
  const Written a = random_expression(random, depth - 1), b = random_expression(random, depth - 1);
  if (pick == 2) return {"(" + a.text + ")+(" + b.text + ")", a.value + b.value};
  if (pick == 3) return {"(" + a.text + ") - (" + b.text + ")", a.value - b.value};
  if (pick == 4) return {"(" + a.text + ")*(" + b.text + ")", a.value * b.value};
  return {"max(" + a.text + "," + b.text + ")", std::max(a.value, b.value)};
}

TEST(Expression, RandomOnes) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const auto written = random_expression(random, 4);
    EXPECT_EQ(value(written.text), written.value) << written.text;
  }
}

TEST(Expression, RandomTextNeverHangsOrCrashes) {
  std::mt19937 random(4);
  const std::string alphabet = "0123456789.+-*/%()&,eEdD abmaxsinpi<>\"\t\0#";
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (auto n = random() % 30; n > 0; --n) text += alphabet[random() % alphabet.size()];
    const auto result = evaluate_expression(text, names);
    if (result.ok()) {
      EXPECT_TRUE(std::isfinite(result.value())) << text;
    }
  }
}

}  // namespace
}  // namespace gapcheck::keyword::expression_test
