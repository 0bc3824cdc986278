#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "audit/ignores.hpp"

namespace gapcheck::app {

/// What a key of a settings file takes.
enum class SettingType : std::uint8_t { word, rules, ids, ranges, amount, count, path, paths, patterns, day, text };

/// One key that a settings file may have.
struct SettingKey {
  std::string_view table;  ///< "" for the top level
  std::string_view name;
  SettingType type;
  std::string_view option;     ///< the command-line option that it represents; empty: none
  std::string_view meaning{};  ///< if no option gives it
  bool reading = false;        ///< used by every command that reads a deck; otherwise only by audit
};

/// All keys, the top level first. Those of [severity] are the rules and not among them.
[[nodiscard]] std::span<const SettingKey> setting_keys();
/// nullptr: there is none.
[[nodiscard]] const SettingKey* find_setting_key(std::string_view table, std::string_view name);

/// The tables that a settings file may have: "include", …
[[nodiscard]] std::span<const std::string_view> setting_tables();

/// What to write for a value of the type.
[[nodiscard]] std::string_view expected(SettingType type);
/// True if a list of values is allowed.
[[nodiscard]] bool takes_list(SettingType type);
/// What is wrong with a value, as text; empty: nothing. Words and counts are checked by the options they represent.
[[nodiscard]] std::string what_is_wrong(SettingType type, const std::string& value);

/// "3" or "1-500", ids above 0.
[[nodiscard]] std::optional<audit::IdRange> parse_range(std::string_view text);
/// "2027-01-31".
[[nodiscard]] std::optional<std::chrono::year_month_day> parse_day(std::string_view text);

/// "; did you mean \"select\"?" with the most similar key of the table, or table; empty if none is similar.
[[nodiscard]] std::string suggestion(std::string_view table, std::string_view name);

}  // namespace gapcheck::app
