#include "keyword/text/expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/number.hpp"

namespace gapcheck::keyword {
namespace {

constexpr int max_depth = 100;
constexpr std::size_t max_length = 10000;
constexpr std::size_t max_arguments = 100;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

using Number = ExpressionNumber;

/// The type of a function's value.
enum class Kind : std::uint8_t { real, integer, as_arguments };

struct Function {
  std::string_view name;
  double (*value)(double);
  Kind kind = Kind::real;
};

struct BinaryFunction {
  std::string_view name;
  double (*value)(double, double);
  Kind kind = Kind::real;
};

constexpr std::array functions{
    Function{"sin", [](double x) { return std::sin(x); }},
    Function{"cos", [](double x) { return std::cos(x); }},
    Function{"tan", [](double x) { return std::tan(x); }},
    Function{"csc", [](double x) { return 1 / std::sin(x); }},
    Function{"sec", [](double x) { return 1 / std::cos(x); }},
    Function{"ctn", [](double x) { return 1 / std::tan(x); }},
    Function{"asin", [](double x) { return std::asin(x); }},
    Function{"acos", [](double x) { return std::acos(x); }},
    Function{"atan", [](double x) { return std::atan(x); }},
    Function{"sinh", [](double x) { return std::sinh(x); }},
    Function{"cosh", [](double x) { return std::cosh(x); }},
    Function{"tanh", [](double x) { return std::tanh(x); }},
    Function{"asinh", [](double x) { return std::asinh(x); }},
    Function{"acosh", [](double x) { return std::acosh(x); }},
    Function{"atanh", [](double x) { return std::atanh(x); }},
    Function{"sqrt", [](double x) { return std::sqrt(x); }},
    Function{"abs", [](double x) { return std::abs(x); }, Kind::as_arguments},
    Function{"exp", [](double x) { return std::exp(x); }},
    Function{"log", [](double x) { return std::log(x); }},
    Function{"log10", [](double x) { return std::log10(x); }},
    Function{"int", [](double x) { return std::trunc(x); }, Kind::integer},
    Function{"aint", [](double x) { return std::trunc(x); }},
    Function{"nint", [](double x) { return std::round(x); }, Kind::integer},
    Function{"anint", [](double x) { return std::round(x); }},
    Function{"float", [](double x) { return x; }},
};

constexpr std::array binary_functions{
    BinaryFunction{"atan2", [](double y, double x) { return std::atan2(y, x); }},
    BinaryFunction{"sign", [](double x, double s) { return std::copysign(std::abs(x), s); }, Kind::as_arguments},
    BinaryFunction{"mod", [](double x, double y) { return std::fmod(x, y); }, Kind::as_arguments},
};

/// Of two integers the part before the point.
Number quotient(const Number& a, const Number& b) {
  if (!a.whole || !b.whole) return {a.value / b.value};
  return {(a.value - std::fmod(a.value, b.value)) / b.value, true};
}

/// Recursive descent. The first problem stops everything: afterwards every step returns zero at once.
class Evaluator {
 public:
  Evaluator(std::string_view text, const std::function<Result<Number>(std::string_view)>& value_of)
      : text_(text), value_of_(value_of) {}

  Result<double> run() {
    if (text_.size() > max_length) fail("is longer than " + std::to_string(max_length) + " characters");
    const double value = sum(0).value;
    if (peek(); status_.ok() && at_ < text_.size()) fail("unexpected \"" + std::string(1, text_[at_]) + "\"");
    if (status_.ok() && !std::isfinite(value)) fail("has no finite value");
    if (!status_.ok())
      return plain_error("expression \"" + std::string(text_.substr(0, 80)) + "\": " + status_.error().message);
    return value;
  }

 private:
  Number fail(std::string problem) {
    if (status_.ok()) status_ = plain_error(std::move(problem));
    at_ = text_.size();
    return {};
  }

  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool accept(std::string_view token) {
    if (peek() == '\0' || !text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  Number sum(int depth) {
    if (depth > max_depth) return fail("is nested too deeply");
    Number value = product(depth);
    while (status_.ok()) {
      const bool plus = accept("+");
      if (!plus && !accept("-")) break;
      const Number right = product(depth);
      value = {plus ? value.value + right.value : value.value - right.value, value.whole && right.whole};
    }
    return value;
  }

  Number product(int depth) {
    Number value = signed_power(depth);
    while (status_.ok()) {
      // signed_power would have handled a power.
      const char operation = peek();
      if (operation != '*' && operation != '/' && operation != '%') break;
      ++at_;
      const Number right = signed_power(depth);
      if (operation == '*')
        value = {value.value * right.value, value.whole && right.whole};
      else if (right.value == 0)
        return fail("divides by zero");
      else if (operation == '/')
        value = quotient(value, right);
      else
        value = {std::fmod(value.value, right.value), value.whole && right.whole};
    }
    return value;
  }

  Number signed_power(int depth) {
    if (depth > max_depth) return fail("is nested too deeply");
    if (accept("-")) {
      const Number value = signed_power(depth + 1);
      return {-value.value, value.whole};
    }
    if (accept("+")) return signed_power(depth + 1);
    const Number base = primary(depth);
    if (!accept("**")) return base;
    const Number power = signed_power(depth + 1);
    return {std::pow(base.value, power.value), base.whole && power.whole && power.value >= 0};
  }

  Number primary(int depth) {
    const char c = peek();
    if (accept("(")) {
      const Number value = sum(depth + 1);
      return accept(")") ? value : fail("lacks a \")\"");
    }
    if (is_digit(c) || c == '.') return number();
    if (c == '&') ++at_;
    if (at_ < text_.size() && is_letter(text_[at_])) return name_or_call(depth, c == '&');
    return c == '\0' ? fail("ends too early") : fail("unexpected \"" + std::string(1, c) + "\"");
  }

  void take_digits() {
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }

  Number number() {
    const auto begin = at_;
    take_digits();
    const auto digits_end = at_;
    if (at_ < text_.size() && text_[at_] == '.') ++at_;
    take_digits();
    if (at_ < text_.size() && std::string_view("eEdD").find(text_[at_]) != std::string_view::npos) {
      const auto mantissa_end = at_++;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      if (at_ < text_.size() && is_digit(text_[at_]))
        take_digits();
      else
        at_ = mantissa_end;
    }
    const auto word = text_.substr(begin, at_ - begin);
    const auto value = parse_real(word);
    return value ? Number{*value, at_ == digits_end} : fail("\"" + std::string(word) + "\" is not a number");
  }

  Number name_or_call(int depth, bool is_parameter) {
    const auto begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const auto name = text_.substr(begin, at_ - begin);
    if (!is_parameter && accept("(")) return call(name, depth);
    const auto value = value_of_(name);
    if (value) return value.value();
    if (!is_parameter && lower_case(name) == "pi") return {std::numbers::pi};
    return fail(value.error().message);
  }

  static std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
  }

  Number call(std::string_view written, int depth) {
    std::vector<double> arguments;
    bool whole = true;  // all arguments
    do {
      if (arguments.size() == max_arguments) return fail("has too many arguments");
      const Number argument = sum(depth + 1);
      arguments.push_back(argument.value);
      whole = whole && argument.whole;
    } while (accept(","));
    if (!accept(")")) return fail("lacks a \")\"");
    if (!status_.ok()) return {};
    const std::string name = lower_case(written);
    if (name == "min") return {*std::min_element(arguments.begin(), arguments.end()), whole};
    if (name == "max") return {*std::max_element(arguments.begin(), arguments.end()), whole};
    for (const auto& function : functions)
      if (function.name == name)
        return arguments.size() == 1 ? checked(function.value(arguments[0]), function, whole)
                                     : fail(name + " takes one argument");
    for (const auto& function : binary_functions)
      if (function.name == name)
        return arguments.size() == 2 ? checked(function.value(arguments[0], arguments[1]), function, whole)
                                     : fail(name + " takes two arguments");
    return fail("unknown function \"" + std::string(written) + "\"");
  }

  template <class AnyFunction>
  Number checked(double value, const AnyFunction& function, bool whole) {
    if (!std::isfinite(value)) return fail(std::string(function.name) + " has no finite value there");
    return {value, function.kind == Kind::integer || (function.kind == Kind::as_arguments && whole)};
  }

  std::string_view text_;
  const std::function<Result<Number>(std::string_view)>& value_of_;
  std::size_t at_ = 0;
  Status status_;
};

}  // namespace

Result<double> evaluate_expression(std::string_view text,
                                   const std::function<Result<ExpressionNumber>(std::string_view)>& value_of) {
  return Evaluator(text, value_of).run();
}

}  // namespace gapcheck::keyword
