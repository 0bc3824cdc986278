#include "keyword/parameters.hpp"

#include <algorithm>

#include "keyword/expression.hpp"

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

void Parameters::define(std::string_view name, ParameterValue value, std::uint32_t scope, std::uint32_t order) {
  definitions_[lower_case(name)][scope].push_back({order, std::move(value)});
}

const ParameterValue* Parameters::find(std::string_view name, std::uint32_t scope, std::uint32_t order) const {
  const auto found = definitions_.find(lower_case(name));
  if (found == definitions_.end()) return nullptr;
  while (true) {
    if (const auto in_scope = found->second.find(scope); in_scope != found->second.end()) {
      const auto& list = in_scope->second;
      const auto after = std::partition_point(list.begin(), list.end(),
                                              [&](const Definition& definition) { return definition.order < order; });
      if (after != list.begin()) return &std::prev(after)->value;
    }
    if (scope == global) return nullptr;
    scope = parents_[scope];
  }
}

Result<double> Parameters::evaluate(std::string_view expression, std::uint32_t scope, std::uint32_t order) const {
  return evaluate_expression(expression, [&](std::string_view name) -> Result<double> {
    const ParameterValue* value = find(name, scope, order);
    if (value == nullptr) return failure("the parameter \"" + std::string(name) + "\" is not defined before this line");
    if (const auto* integer = std::get_if<std::int64_t>(value)) return static_cast<double>(*integer);
    if (const auto* real = std::get_if<double>(value)) return *real;
    return failure("the parameter \"" + std::string(name) + "\" is a text, not a number");
  });
}

}  // namespace gapcheck::keyword
