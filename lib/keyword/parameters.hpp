#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.hpp"

namespace gapcheck::keyword {

using ParameterValue = std::variant<std::int64_t, double, std::string>;

/// Whether a field for a number names a parameter or holds an expression instead of its value: `&name`, `-&name`,
/// `<expression>`, and anything else with a parameter in it, like `2*&name`.
[[nodiscard]] inline bool is_parameter_reference(std::string_view field) {
  return field.starts_with('<') || field.find('&') != std::string_view::npos;
}

/// Letters, digits and underscores only, as names in expressions have them.
[[nodiscard]] bool is_plain_name(std::string_view name);

/// The values of *PARAMETER and its relatives, with the place from which each is visible.
class Parameters {
 public:
  static constexpr std::uint32_t global = 0;  ///< the scope visible to every file

  /// Makes a scope inside another (a file inside the file that includes it).
  std::uint32_t add_scope(std::uint32_t parent);
  /// Definitions of one name in one scope must come in ascending order; of several with the same order the last counts.
  void define(std::string_view name, ParameterValue value, std::uint32_t scope, std::uint32_t order);
  /// The last definition before `order` visible in the scope, innermost scope first; names ignore case.
  [[nodiscard]] const ParameterValue* find(std::string_view name, std::uint32_t scope, std::uint32_t order) const;
  /// The value of an expression as *PARAMETER_EXPRESSION and `<...>` fields hold it. Bounded in depth.
  /// Errors say what is wrong: syntax, unknown name, division by zero, no finite value.
  [[nodiscard]] Result<double> evaluate(std::string_view expression, std::uint32_t scope, std::uint32_t order) const;

 private:
  struct Definition {
    std::uint32_t order;
    ParameterValue value;
  };
  using ByScope = std::map<std::uint32_t, std::vector<Definition>>;  ///< definitions by ascending order
  std::vector<std::uint32_t> parents_{global};
  std::map<std::string, ByScope, std::less<>> definitions_;  ///< by lower-case name
};

}  // namespace gapcheck::keyword
