#include "keyword/layout.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/embedded.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> keyword_layouts;
}

namespace gapcheck::keyword {
namespace {

using FieldLists = std::unordered_map<std::string_view, std::vector<Field>>;
using Table = std::map<std::string, KeywordLayout, std::less<>>;

/// Cuts off the text up to the separator (or all of it) and returns it.
std::string_view take(std::string_view& text, char separator) {
  const auto end = std::min(text.find(separator), text.size());
  const auto word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

std::uint16_t number(std::string_view text) {
  std::uint16_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::pair<FieldType, IdKind> type_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, IdKind>, 8> kinds{{{"node", IdKind::node},
                                                                      {"element", IdKind::element},
                                                                      {"part", IdKind::part},
                                                                      {"material", IdKind::material},
                                                                      {"set", IdKind::set},
                                                                      {"function", IdKind::function},
                                                                      {"define", IdKind::define},
                                                                      {"other", IdKind::other}}};
  if (name == "real") return {FieldType::real, IdKind::plain};
  if (name == "text") return {FieldType::text, IdKind::plain};
  for (const auto& [word, kind] : kinds)
    if (name == word) return {FieldType::integer, kind};
  return {FieldType::integer, IdKind::plain};
}

std::vector<Field> parse_fields(std::string_view line) {
  std::vector<Field> fields;
  while (!line.empty()) {
    auto word = take(line, ' ');
    Field field;
    field.name = take(word, ':');
    field.column = number(take(word, ':'));
    field.width = number(take(word, ':'));
    std::tie(field.type, field.id) = type_of(take(word, ':'));
    const int count = word.empty() ? 1 : number(word.substr(1));
    for (int i = 0; i < count; ++i) {
      fields.push_back(field);
      field.column = static_cast<std::uint16_t>(field.column + field.width);
    }
  }
  return fields;
}

std::vector<Field> fields_named(std::string_view name, const FieldLists& lists, const Table& table) {
  if (const auto found = lists.find(name); found != lists.end()) return found->second;
  const auto keyword = table.find(take(name, '/'));
  const CardLayout* card = keyword == table.end() ? nullptr : keyword->second.card(name);
  return card != nullptr ? card->fields : std::vector<Field>{};
}

void add_cards(std::string_view line, const FieldLists& lists, Table& table) {
  const std::string name(take(line, ' '));
  KeywordLayout& keyword = table[name];
  keyword.name = name;
  while (!line.empty()) {
    auto word = take(line, ' ');
    const auto card_name = take(word, '=');
    auto fields = fields_named(word, lists, table);
    const auto same = std::find_if(keyword.cards.begin(), keyword.cards.end(),
                                   [&](const CardLayout& card) { return card.name == card_name; });
    if (same != keyword.cards.end())
      same->fields = std::move(fields);
    else
      keyword.cards.push_back({std::string(card_name), std::move(fields)});
  }
}

/// `#` in the pattern matches one or more digits.
bool field_matches(std::string_view name, std::string_view pattern) {
  while (!pattern.empty() && !name.empty()) {
    if (pattern.front() == '#') {
      const auto digits = std::min(name.find_first_not_of("0123456789"), name.size());
      if (digits == 0) return false;
      name.remove_prefix(digits);
    } else {
      if (pattern.front() != name.front()) return false;
      name.remove_prefix(1);
    }
    pattern.remove_prefix(1);
  }
  return pattern.empty() && name.empty();
}

void set_kind(std::string_view line, Table& table) {
  auto keywords = take(line, ' ');
  const auto field_pattern = take(line, ' ');
  const auto [type, kind] = type_of(line);
  const bool prefix = keywords.ends_with('*');
  if (prefix) keywords.remove_suffix(1);
  for (auto entry = table.lower_bound(keywords); entry != table.end(); ++entry) {
    if (prefix ? !std::string_view(entry->first).starts_with(keywords) : entry->first != keywords) break;
    for (CardLayout& card : entry->second.cards)
      for (Field& field : card.fields)
        if (field.type == FieldType::integer && field_matches(field.name, field_pattern)) field.id = kind;
  }
}

Table build_table() {
  FieldLists lists;
  Table table;
  for (const auto& text : embedded::keyword_layouts) {
    auto rest = text.content;
    while (!rest.empty()) {
      auto line = take(rest, '\n');
      const auto verb = take(line, ' ');
      if (verb == "fields") {
        const auto name = take(line, ' ');
        lists[name] = parse_fields(line);
      } else if (verb == "card") {
        add_cards(line, lists, table);
      } else if (verb == "kind") {
        set_kind(line, table);
      }
    }
  }
  return table;
}

const Table& table() {
  static const Table built = build_table();
  return built;
}

}  // namespace

std::size_t CardLayout::index(std::string_view field) const {
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].name == field) return i;
  return npos;
}

const CardLayout* KeywordLayout::card(std::string_view card_name) const {
  for (const CardLayout& card : cards)
    if (card.name == card_name) return &card;
  return nullptr;
}

const KeywordLayout* find_layout(std::string_view keyword) {
  const auto found = table().find(keyword);
  return found == table().end() ? nullptr : &found->second;
}

std::vector<std::string_view> layout_names(std::string_view prefix) {
  std::vector<std::string_view> names;
  for (auto entry = table().lower_bound(prefix); entry != table().end() && entry->first.starts_with(prefix); ++entry)
    names.push_back(entry->first);
  return names;
}

const CardLayout& card_layout(std::string_view keyword, std::string_view card) {
  const KeywordLayout* layout = find_layout(keyword);
  const CardLayout* found = layout == nullptr ? nullptr : layout->card(card);
  // A name that is not in the table is a mistake in the program, never in a deck.
  if (found == nullptr) std::abort();
  return *found;
}

const KeywordLayout* find_layout_of(std::string_view name) {
  while (true) {
    if (const KeywordLayout* layout = find_layout(name)) return layout;
    const auto cut = name.rfind('_');
    if (cut == std::string_view::npos) return nullptr;
    name = name.substr(0, cut);
  }
}

}  // namespace gapcheck::keyword
