#include "audit/ignore_comment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "audit/registry.hpp"
#include "base/nearest_name.hpp"
#include "base/number.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// The text in quotation marks, cut if long; bytes unsuitable for messages become question marks.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out = "\"";
  for (const char c : text.substr(0, longest)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (text.size() > longest ? "…\"" : "\"");
}

class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  IgnoreComment read() {
    if (lower_case(word()) != "ignore")
      return {{},
              fmt::format("a comment that starts with \"gapcheck:\" needs the word ignore and rules behind it: "
                          "$ gapcheck: ignore {} contact=3 because …",
                          record_rules::initial_penetration.id)};
    read_rules();
    while (wrong_.empty() && !at_end()) read_clause();
    if (!wrong_.empty()) return {{}, wrong_};
    return {entry_, {}};
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size())); }
  bool at_end() {
    skip_blanks();
    return rest_.empty();
  }
  bool take(char c) {
    skip_blanks();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Up to a blank, a comma or an equals sign.
  std::string_view word() {
    skip_blanks();
    const auto found = rest_.substr(0, rest_.find_first_of(" \t\r,="));
    rest_.remove_prefix(found.size());
    return found;
  }

  void read_rules() {
    do {
      const std::string_view pattern = word();
      if (pattern.empty() || rest_.starts_with('=')) {
        wrong_ = fmt::format("an ignore names the rules that it is about; write ignore {0} or ignore {0},{1}",
                             record_rules::initial_penetration.id, record_rules::untied_node.name);
        return;
      }
      check_rule(pattern);
      if (!wrong_.empty()) return;
      entry_.rules.emplace_back(pattern);
    } while (take(','));
  }

  void check_rule(std::string_view pattern) {
    const std::vector<std::string> patterns{std::string(pattern)};
    bool of_runs = false, of_ignores = false;
    for (const RuleIdentity& rule : rules()) {
      if (!selected(rule, patterns, {})) continue;
      if (!rule.of_runs() && !rule.of_ignores()) return;
      (rule.of_runs() ? of_runs : of_ignores) = true;
    }
    if (of_runs)
      wrong_ = quoted(pattern) +
               " judges what a run has written, which no comment of a deck can leave out; "
               "use --ignore with messag";
    else if (of_ignores)
      wrong_ = quoted(pattern) + " is about ignores and cannot be ignored by a comment; use --ignore";
    else
      wrong_ = quoted(pattern) + " is not a rule" + did_you_mean(nearest_rule(pattern, false)) +
               " (gapcheck rules lists them)";
  }

  /// One `key=value` or the reason.
  void read_clause() {
    static constexpr std::array<std::string_view, 6> keys{"contact", "node", "part", "element", "until", "because"};
    const std::string_view written = word();
    const std::string key = lower_case(written);
    if (key == "because") return read_reason();
    const auto known = std::find(keys.begin(), keys.end(), key);
    if (known == keys.end()) {
      const std::string_view text = written.empty() ? rest_.substr(0, 1) : written;
      wrong_ = quoted(text) + " is not understood" + did_you_mean(nearest_name(text, keys)) +
               " (contact=, node=, part=, element=, until=, because)";
      return;
    }
    if (!take('=')) {
      wrong_ = fmt::format("{} needs a value: write {}=…", key, key);
      return;
    }
    bool& there = seen_[static_cast<std::size_t>(known - keys.begin())];
    if (there) {
      wrong_ = fmt::format("{}= stands there twice; put everything into one", key);
      return;
    }
    there = true;
    if (key == "until") return read_until();
    read_ids(key, key == "contact" ? entry_.contacts
                  : key == "node"  ? entry_.nodes
                  : key == "part"  ? entry_.parts
                                   : entry_.elements);
  }

  void read_reason() {
    entry_.reason = std::string(trimmed(rest_));
    if (!entry_.reason.empty() && entry_.reason.back() == '\r') entry_.reason.pop_back();
    rest_ = {};
    if (entry_.reason.empty()) wrong_ = "because needs a reason behind it; give it, or remove the word";
  }

  void read_until() {
    const std::string_view text = word();
    const auto number = [&](std::size_t from, std::size_t size) -> std::optional<int> {
      int value = 0;
      const char* end = text.data() + from + size;
      const auto [stop, error] = std::from_chars(text.data() + from, end, value);
      return error == std::errc{} && stop == end && value >= 0 ? std::optional(value) : std::nullopt;
    };
    if (text.size() == 10 && text[4] == '-' && text[7] == '-') {
      const auto year = number(0, 4), month = number(5, 2), day = number(8, 2);
      if (year && month && day) {
        const std::chrono::year_month_day date(std::chrono::year(*year),
                                               std::chrono::month(static_cast<unsigned>(*month)),
                                               std::chrono::day(static_cast<unsigned>(*day)));
        if (date.ok()) {
          entry_.until = date;
          return;
        }
      }
    }
    wrong_ = quoted(text) + " is not a day; write until=YYYY-MM-DD";
  }

  /// An id from 1; otherwise says what is wrong.
  std::optional<std::int64_t> id(std::string_view text, std::string_view key) {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range)
      wrong_ = quoted(text) + " is larger than any id";
    else if (error != std::errc{} || stop != text.data() + text.size() || value < 1)
      wrong_ = fmt::format("{} is not an id; write {}=3 or {}=1-500,803", quoted(text), key, key);
    return wrong_.empty() ? std::optional(value) : std::nullopt;
  }

  void read_ids(const std::string& key, std::vector<IdRange>& ids) {
    do {
      const std::string_view item = word();
      const auto dash = item.find('-', 1);
      const auto first = id(item.substr(0, dash), key);
      const auto last = first && dash != item.npos ? id(item.substr(dash + 1), key) : first;
      if (!first || !last) return;
      if (*first > *last) {
        wrong_ = fmt::format("the range {}-{} runs backwards; write {}-{}", *first, *last, *last, *first);
        return;
      }
      ids.push_back({*first, *last});
    } while (take(','));
  }

  std::string_view rest_;
  IgnoreEntry entry_;
  std::array<bool, 6> seen_{};
  std::string wrong_;
};

}  // namespace

IgnoreComment read_ignore_comment(std::string_view text) { return Parser(text).read(); }

}  // namespace gapcheck::audit
