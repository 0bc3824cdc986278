#include "settings_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "audit/registry.hpp"
#include "base/number.hpp"
#include "report/describe.hpp"

// The library compiled into this file alone, with errors as values.
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 32
// A table [.a] breaks an assumption of version 3.3, which then refuses it all the same: assumptions must neither end
// the program nor be taken for true.
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

/// Values of one key as text, and where they stand.
struct Given {
  std::vector<std::string> values;
  std::uint32_t line = 0;
};
using GivenTable = std::map<std::string_view, Given>;

std::uint32_t line_of(const toml::node& node) { return node.source().begin.line; }

/// A single value as text, if it is of the type's kind.
std::optional<std::string> value_of(const toml::node& node, SettingType type) {
  using enum SettingType;
  const bool whole = type == ids || type == ranges || type == count || type == amount;
  const bool words = !whole || type == ranges;
  if (const auto* value = node.as_integer(); value != nullptr && whole) return fmt::format("{}", value->get());
  if (const auto* value = node.as_floating_point(); value != nullptr && type == amount)
    return fmt::format("{}", value->get());
  if (const auto* value = node.as_date(); value != nullptr && type == day)
    return fmt::format("{:04}-{:02}-{:02}", value->get().year, value->get().month, value->get().day);
  if (const auto* value = node.as_string(); value != nullptr && words) return value->get();
  return std::nullopt;
}

/// "./lib/" as patterns are: "lib/**".
std::string normal_pattern(const std::string& pattern) {
  std::string normal = fs::path(pattern).lexically_normal().string();
  if (normal.ends_with('/')) normal += "**";
  return normal;
}

/// Control characters, such as line breaks, become blanks.
std::string one_line(std::string text) {
  std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

class Reader {
 public:
  Reader(const std::string& path, Diagnostics& diagnostics)
      : folder_(fs::path(path).parent_path()), diagnostics_(diagnostics) {
    settings_.path = path;
  }

  Settings read(const toml::table& root) {
    for (const auto& [key, node] : root) {
      const std::string_view name = key.str();
      if (name == "severity")
        read_severities(node);
      else if (const auto& tables = setting_tables(); std::find(tables.begin(), tables.end(), name) != tables.end())
        read_entries(name, node);
      else if (auto given = read_key("", key, node); given && !given->values.empty())
        settings_.options.push_back({find_setting_key("", name), std::move(given->values), given->line});
    }
    return std::move(settings_);
  }

 private:
  void error(std::uint32_t line, std::string message) {
    diagnostics_.error(settings_.path, line, std::move(message));
  }

  std::optional<std::string> read_value(std::string_view name, const toml::node& node, SettingType type) {
    std::optional<std::string> value = value_of(node, type);
    if (!value) {
      error(line_of(node), fmt::format("{} must be {}", name, expected(type)));
      return std::nullopt;
    }
    const std::string wrong = what_is_wrong(type, *value);
    if (!wrong.empty()) {
      error(line_of(node), fmt::format("{}: {}", name, wrong));
      return std::nullopt;
    }
    if (type == SettingType::path || type == SettingType::paths)
      value = (folder_ / *value).lexically_normal().string();
    return value;
  }

  /// Nothing after an error, which has been said.
  std::optional<Given> read_key(std::string_view table, const toml::key& key, const toml::node& node) {
    const std::string_view name = key.str();
    const SettingKey* known = find_setting_key(table, name);
    if (known == nullptr) {
      const std::string place = table.empty() ? "" : fmt::format(" of [[{}]]", table);
      error(key.source().begin.line,
            fmt::format("unknown key \"{}\"{}{}", name.substr(0, 64), place, suggestion(table, name)));
      return std::nullopt;
    }
    Given given{{}, line_of(node)};
    const auto* list = takes_list(known->type) ? node.as_array() : nullptr;
    if (list == nullptr) {
      if (auto value = read_value(name, node, known->type)) given.values.push_back(std::move(*value));
      return given.values.empty() ? std::nullopt : std::optional(std::move(given));
    }
    for (const toml::node& element : *list)
      if (auto value = read_value(name, element, known->type)) given.values.push_back(std::move(*value));
    return given.values.size() == list->size() ? std::optional(std::move(given)) : std::nullopt;
  }

  void read_severities(const toml::node& node) {
    const auto* table = node.as_table();
    if (table == nullptr) return error(line_of(node), "severity must be a table: [severity]");
    for (const auto& [key, value] : *table) {
      const std::uint32_t line = key.source().begin.line;
      const audit::RuleInfo* rule = audit::find_rule(key.str());
      if (rule == nullptr || rule->of_runs) {
        error(line, fmt::format("'{}' is no rule on decks; gapcheck rules lists them", key.str().substr(0, 64)));
        continue;
      }
      const auto* word = value.as_string();
      std::optional<Severity> severity;
      for (const Severity s : {Severity::error, Severity::warning, Severity::note})
        if (word != nullptr && word->get() == report::name(s)) severity = s;
      if (!severity)
        error(line, fmt::format("{} must be \"error\", \"warning\" or \"note\"", key.str()));
      else if (!settings_.severities.emplace(rule->id, *severity).second)
        error(line, fmt::format("the severity of {} is given twice: by id and by name", rule->id));
    }
  }

  /// [[include]] or [[exception]].
  void read_entries(std::string_view table, const toml::node& node) {
    const auto* list = node.as_array();
    if (list == nullptr || !list->is_array_of_tables())
      return error(line_of(node), fmt::format("{0} must be written as [[{0}]]", table));
    for (const toml::node& element : *list) read_entry(table, *element.as_table());
  }

  void read_entry(std::string_view table, const toml::table& entry) {
    GivenTable given;
    bool good = true;
    for (const auto& [key, node] : entry) {
      auto values = read_key(table, key, node);
      if (values && values->values.empty()) {
        error(values->line, fmt::format("{} is empty; leave it out", key.str()));
        values.reset();
      }
      if (values)
        given.emplace(find_setting_key(table, key.str())->name, std::move(*values));
      else
        good = false;
    }
    if (!good) return;
    if (table == "include")
      add_include(given, line_of(entry));
    else
      add_exception(given, line_of(entry));
  }

  /// What both kinds of tables have in common.
  audit::IgnoreEntry entry_of(const GivenTable& given, std::uint32_t line) {
    audit::IgnoreEntry entry;
    entry.file = settings_.path;
    entry.line = line;
    entry.base = folder_.empty() ? "." : folder_.string();
    if (const auto day = given.find("until"); day != given.end()) entry.until = parse_day(day->second.values.front());
    if (const auto text = given.find("because"); text != given.end())
      entry.reason = one_line(text->second.values.front());
    return entry;
  }

  /// One demand per pattern and limit: each holds by itself.
  void add_include(const GivenTable& given, std::uint32_t line) {
    const auto rules = given.find("ignore"), ptol = given.find("ptol"), ratio = given.find("ratio"), end = given.end();
    if (!given.contains("path")) return error(line, "[[include]] names no files: path = \"lib/*.k\"");
    if (rules == end && ptol == end && ratio == end)
      return error(line, "[[include]] says nothing of its files; give ignore, ptol or ratio");
    audit::IgnoreEntry entry = entry_of(given, line);
    for (const std::string& pattern : given.at("path").values) {
      entry.files = normal_pattern(pattern);
      entry.ptol = entry.ratio = -1;
      if (rules != end) {
        entry.rules = rules->second.values;
        settings_.ignores.push_back({entry, {}});
      }
      entry.rules = {"GC1"};  // only penetrations have a depth
      if (ptol != end) {
        entry.ptol = *parse_real(ptol->second.values.front());
        settings_.ignores.push_back({entry, {}});
        entry.ptol = -1;
      }
      if (ratio != end) {
        entry.ratio = *parse_real(ratio->second.values.front());
        settings_.ignores.push_back({entry, {}});
      }
    }
  }

  void add_exception(const GivenTable& given, std::uint32_t line) {
    if (!given.contains("ignore")) return error(line, "[[exception]] names no rules: ignore = \"GC101\"");
    audit::IgnoreEntry entry = entry_of(given, line);
    entry.rules = given.at("ignore").values;
    const auto take = [&](std::string_view key, std::vector<audit::IdRange>& ranges) {
      if (const auto found = given.find(key); found != given.end())
        for (const std::string& range : found->second.values) ranges.push_back(*parse_range(range));
    };
    take("contact", entry.contacts);
    take("node", entry.nodes);
    take("part", entry.parts);
    take("element", entry.elements);
    std::vector<std::string> decks;
    if (const auto patterns = given.find("deck"); patterns != given.end())
      for (const std::string& pattern : patterns->second.values) decks.push_back(normal_pattern(pattern));
    settings_.ignores.push_back({std::move(entry), std::move(decks)});
  }

  Settings settings_;
  fs::path folder_;
  Diagnostics& diagnostics_;
};

/// The first line with a key of so many names that tables in each other could exhaust the stack; 0: none. Texts with so
/// many dots are taken for keys, too.
std::uint32_t line_of_deep_key(std::string_view text) {
  constexpr int most_names = 100;
  constexpr std::string_view ends = "\n=,[]{}#";
  std::uint32_t line = 1;
  int dots = 0;
  for (const char c : text) {
    if (c == '.' && ++dots >= most_names) return line;
    if (ends.find(c) != std::string_view::npos) dots = 0;
    if (c == '\n') ++line;
  }
  return 0;
}

}  // namespace

Settings read_settings(std::string_view text, const std::string& path, Diagnostics& diagnostics) {
  if (const std::uint32_t line = line_of_deep_key(text); line > 0) {
    diagnostics.error(path, line, "a key of too many names, or 100 dots in one text");
    return {path, {}, {}, {}};
  }
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    diagnostics.error(path, error.source().begin.line, fmt::format("is no TOML: {}", error.description()));
    return {path, {}, {}, {}};
  }
  return Reader(path, diagnostics).read(parsed.table());
}

}  // namespace gapcheck::app
