#include "keyword/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/number.hpp"
#include "keyword/text/expression.hpp"

namespace gapcheck::keyword {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

Diagnostic failure(std::string message) { return {Severity::error, {}, 0, std::move(message)}; }

}  // namespace

bool is_plain_name(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  });
}

std::uint32_t Parameters::add_scope(std::uint32_t parent) {
  parents_.push_back(parent);
  return static_cast<std::uint32_t>(parents_.size() - 1);
}

void Parameters::give(std::string_view name, std::string_view text) {
  const std::string_view digits = text.substr(std::min(text.size(), text.find_first_not_of("+-")));
  const bool whole = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  Given given{std::string(text), std::string(text)};
  if (const auto real = parse_real(text)) given.value = *real;
  if (whole)
    if (const auto integer = parse_integer(text)) given.value = *integer;
  given_.insert_or_assign(lower_case(name), std::move(given));
}

bool Parameters::define(std::string_view name, ParameterValue value, std::uint32_t scope, std::uint32_t order) {
  const std::string key = lower_case(name);
  bool fits = true;
  if (const auto found = given_.find(key); found != given_.end()) {
    const Given& given = found->second;
    *given.used = true;
    if (std::holds_alternative<std::string>(value)) {
      value = given.text;
    } else if (std::holds_alternative<double>(value)) {
      const auto real = parse_real(given.text);
      fits = real.has_value();
      if (real) value = *real;
    } else {
      const auto integer = parse_integer(given.text);
      fits = integer.has_value();
      if (integer) value = *integer;
    }
  }
  definitions_[key][scope].push_back({order, std::move(value)});
  return fits;
}

ParameterValue Parameters::unknown() { return std::numeric_limits<double>::quiet_NaN(); }

bool Parameters::is_unknown(const ParameterValue& value) {
  const auto* real = std::get_if<double>(&value);
  return real != nullptr && std::isnan(*real);
}

const std::string* Parameters::given(std::string_view name) const {
  const auto found = given_.empty() ? given_.end() : given_.find(lower_case(name));
  if (found == given_.end()) return nullptr;
  *found->second.used = true;
  return &found->second.text;
}

std::vector<std::string> Parameters::unused() const {
  std::vector<std::string> names;
  for (const auto& [name, given] : given_)
    if (!*given.used) names.push_back(name);
  return names;
}

const ParameterValue* Parameters::find(std::string_view name, std::uint32_t scope, std::uint32_t order) const {
  static const ParameterValue unread = unknown();
  if (name == unread_parameter) return &unread;
  const std::string key = lower_case(name);
  const auto outside = [&]() -> const ParameterValue* {
    const auto found = given_.empty() ? given_.end() : given_.find(key);
    if (found == given_.end()) return nullptr;
    *found->second.used = true;
    return &found->second.value;
  };
  const auto found = definitions_.find(key);
  if (found == definitions_.end()) return outside();
  while (true) {
    if (const auto in_scope = found->second.find(scope); in_scope != found->second.end()) {
      const auto& list = in_scope->second;
      const auto after = std::partition_point(list.begin(), list.end(),
                                              [&](const Definition& definition) { return definition.order < order; });
      if (after != list.begin()) return &std::prev(after)->value;
    }
    if (scope == global) return outside();
    scope = parents_[scope];
  }
}

Result<double> Parameters::evaluate(std::string_view expression, std::uint32_t scope, std::uint32_t order,
                                    Missing* missing) const {
  return evaluate_expression(expression, [&](std::string_view name) -> Result<ExpressionNumber> {
    const ParameterValue* value = find(name, scope, order);
    // Without a parameter of this name it is a constant.
    const bool constant = value == nullptr && lower_case(name) == "pi";
    if (missing != nullptr && !constant && (value == nullptr || is_unknown(*value)))
      *missing = {std::string(name), value != nullptr};
    if (value == nullptr) return failure("the parameter \"" + std::string(name) + "\" is not defined before this line");
    if (const auto* integer = std::get_if<std::int64_t>(value))
      return ExpressionNumber{static_cast<double>(*integer), true};
    if (std::holds_alternative<std::string>(*value))
      return failure("the parameter \"" + std::string(name) + "\" is a text, not a number");
    if (is_unknown(*value)) return failure("the parameter \"" + std::string(name) + "\" could not be read");
    return ExpressionNumber{std::get<double>(*value)};
  });
}

}  // namespace gapcheck::keyword
