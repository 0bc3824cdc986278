#include "settings/setting_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/nearest_name.hpp"
#include "base/number.hpp"
#include "options.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::app {
namespace {

constexpr std::array keys = [] {
  using enum SettingType;
  return std::array{
      SettingKey{"", "units", word, "--units"},
      SettingKey{"", "include-directories", paths, "-I", "", true},
      SettingKey{"", "missing-includes", word, "--missing-includes", "", true},
      SettingKey{"", "jobs", count, "--jobs", "", true},
      SettingKey{"", "select", rules, "--select"},
      SettingKey{"", "ignore", rules, "--ignore"},
      SettingKey{"", "contact", ids, "--contact"},
      SettingKey{"", "part", ids, "--part"},
      SettingKey{"", "ptol", amount, "--ptol"},
      SettingKey{"", "rtol", amount, "--rtol"},
      SettingKey{"", "ratio", amount, "--ratio"},
      SettingKey{"", "format", word, "--format"},
      SettingKey{"", "top", count, "--top"},
      SettingKey{"", "fail-on", word, "--fail-on"},
      SettingKey{"", "baseline", path, "--baseline"},
      SettingKey{"include", "path", patterns, "", "The files, as seen from the folder of the settings"},
      SettingKey{"include", "ignore", rules, "", "Rules that are left out there"},
      SettingKey{"include", "ptol", amount, "", "Only penetrations deeper than this there"},
      SettingKey{"include", "ratio", amount, "", "Only penetrations deeper than so much of the contact distance there"},
      SettingKey{"include", "until", day, "", "The last day on which it holds"},
      SettingKey{"include", "because", text, "", "Why"},
      SettingKey{"exception", "ignore", rules, "", "Rules whose findings are left out"},
      SettingKey{"exception", "deck", patterns, "", "Only in these decks, as seen from the folder of the settings"},
      SettingKey{"exception", "contact", ranges, "", "Only findings in these contacts"},
      SettingKey{"exception", "node", ranges, "", "Only findings on these nodes"},
      SettingKey{"exception", "part", ranges, "", "Only findings on these parts"},
      SettingKey{"exception", "element", ranges, "", "Only findings on these elements"},
      SettingKey{"exception", "until", day, "", "The last day on which it holds"},
      SettingKey{"exception", "because", text, "", "Why"},
  };
}();

constexpr std::array<std::string_view, 4> table_names{"include", "exception", "severity", "threshold"};

constexpr std::size_t longest_value = 4096;

/// Bytes below 0x20 and DEL, which never occur in names of files, rules or patterns.
bool has_control_characters(std::string_view value) {
  return std::any_of(value.begin(), value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

std::string wrong_pattern(std::string_view pattern) {
  if (pattern.starts_with('/')) return "is absolute; write it as seen from the folder of this file";
  if (pattern.find('\\') != std::string_view::npos) return "has a \\; folders are parted by /";
  return "";
}

}  // namespace

std::span<const SettingKey> setting_keys() { return keys; }
std::span<const std::string_view> setting_tables() { return table_names; }

const SettingKey* find_setting_key(std::string_view table, std::string_view name) {
  for (const SettingKey& key : keys)
    if (key.table == table && key.name == name) return &key;
  return nullptr;
}

std::string_view expected(SettingType type) {
  using enum SettingType;
  switch (type) {
    case word:
      return "a word in quotes";
    case rules: {
      static const std::string text = fmt::format("rules: \"{0}\" or [\"{0}\", \"{1}\"]",
                                                  record_rules::initial_penetration.id, record_rules::tie_offset.name);
      return text;
    }
    case ids:
      return "ids: 3 or [1, 2]";
    case ranges:
      return "ids above 0: 3, \"1-500\" or [3, \"7-9\"]";
    case amount:
      return "a number of 0 or more";
    case count:
      return "a whole number of 0 or more";
    case path:
      return "a file in quotes";
    case paths:
      return "folders: \"lib\" or [\"lib\", \"../common\"]";
    case patterns:
      return "files: \"lib/*.k\" or [\"lib/**\", \"old.k\"]";
    case day:
      return "a day: 2027-01-31";
    case text:
      return "a text in quotes";
  }
  return "";
}

bool takes_list(SettingType type) {
  using enum SettingType;
  return type == rules || type == ids || type == ranges || type == paths || type == patterns;
}

std::string what_is_wrong(SettingType type, const std::string& value) {
  using enum SettingType;
  if (type == text) return "";
  if (value.empty()) return "is empty";
  if (value.size() > longest_value) return fmt::format("has more than {} characters", longest_value);
  if (has_control_characters(value)) return "has control characters";
  if (type == rules) return check_deck_rule(value);
  if (type == patterns) return wrong_pattern(value);
  const bool good = (type != ranges || parse_range(value)) && (type != day || parse_day(value)) &&
                    (type != amount || check_amount(value).empty());
  return good ? "" : fmt::format("must be {}", expected(type));
}

std::optional<audit::IdRange> parse_range(std::string_view range) {
  const std::size_t dash = range.find('-');
  const auto first = parse_integer(range.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_integer(range.substr(dash + 1));
  if (!first || !last || *first <= 0 || *last < *first) return std::nullopt;
  return audit::IdRange{*first, *last};
}

std::optional<std::chrono::year_month_day> parse_day(std::string_view date) {
  constexpr std::string_view shape = "0000-00-00";
  const auto fits = [](char c, char as) { return as == '-' ? c == '-' : c >= '0' && c <= '9'; };
  if (date.size() != shape.size() || !std::equal(date.begin(), date.end(), shape.begin(), fits)) return std::nullopt;
  const auto number = [&](std::size_t at, std::size_t size) {
    int value = 0;
    for (const char c : date.substr(at, size)) value = 10 * value + (c - '0');
    return value;
  };
  const std::chrono::year_month_day parsed{std::chrono::year(number(0, 4)),
                                           std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                           std::chrono::day(static_cast<unsigned>(number(8, 2)))};
  return parsed.ok() ? std::optional(parsed) : std::nullopt;
}

std::string suggestion(std::string_view table, std::string_view name) {
  std::vector<std::string_view> candidates;
  for (const SettingKey& key : keys)
    if (key.table == table) candidates.push_back(key.name);
  if (table.empty()) candidates.insert(candidates.end(), table_names.begin(), table_names.end());
  const std::string_view best = nearest_name(name, candidates);
  return best.empty() ? "" : fmt::format("; did you mean \"{}\"?", best);
}

}  // namespace gapcheck::app
