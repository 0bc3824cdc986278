#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
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

/// A value that could not be read and was reported; number fields that refer to it report nothing more.
inline constexpr std::string_view unread_parameter = "__";

/// The values of *PARAMETER and its relatives, with the place from which each is visible.
class Parameters {
 public:
  static constexpr std::uint32_t global = 0;  ///< the scope visible to every file

  /// Makes a scope inside another (a file inside the file that includes it).
  std::uint32_t add_scope(std::uint32_t parent);
  /// A value given from outside (--param): whole number, number or text. It replaces the values of all definitions of
  /// the name and is visible everywhere without one.
  void give(std::string_view name, std::string_view text);
  /// Definitions of one name in one scope must come in ascending order; of several with the same order the last counts.
  /// A given value takes the kind of the definition's; false if it cannot.
  bool define(std::string_view name, ParameterValue value, std::uint32_t scope, std::uint32_t order);
  /// The value of a definition that could not be read, which has been reported.
  [[nodiscard]] static ParameterValue unknown();
  [[nodiscard]] static bool is_unknown(const ParameterValue& value);
  /// The last definition before `order` visible in the scope, innermost scope first; names ignore case.
  [[nodiscard]] const ParameterValue* find(std::string_view name, std::uint32_t scope, std::uint32_t order) const;
  /// The text of a given value; nullptr if none was given.
  [[nodiscard]] const std::string* given(std::string_view name) const;
  /// Names of given values that nothing defined and nothing used.
  [[nodiscard]] std::vector<std::string> unused() const;
  /// A name without a value that an expression needs.
  struct Missing {
    std::string name;   ///< empty: all have one
    bool told = false;  ///< it is defined, but its value could not be read
  };
  /// The value of an expression as *PARAMETER_EXPRESSION and `<...>` fields hold it. Bounded in depth.
  /// Errors say what is wrong: syntax, unknown name (then also `missing`), division by zero, no finite value.
  [[nodiscard]] Result<double> evaluate(std::string_view expression, std::uint32_t scope, std::uint32_t order,
                                        Missing* missing = nullptr) const;

 private:
  struct Definition {
    std::uint32_t order;
    ParameterValue value;
  };
  struct Given {
    std::string text;
    ParameterValue value;
    std::shared_ptr<std::atomic<bool>> used = std::make_shared<std::atomic<bool>>(false);
  };
  using ByScope = std::map<std::uint32_t, std::vector<Definition>>;  ///< definitions by ascending order
  std::vector<std::uint32_t> parents_{global};
  std::map<std::string, ByScope, std::less<>> definitions_;  ///< by lower-case name
  std::map<std::string, Given, std::less<>> given_;          ///< the same
};

}  // namespace gapcheck::keyword
