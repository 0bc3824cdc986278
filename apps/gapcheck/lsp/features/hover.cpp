#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "audit/portability/portability_table.hpp"
#include "base/number.hpp"
#include "keyword/known_keywords.hpp"
#include "lsp/features/features.hpp"
#include "model/contact/contact_name.hpp"
#include "model/unknown_keyword.hpp"

namespace gapcheck::app::lsp {
namespace {

using keyword::CardLayout;
using keyword::Field;
using keyword::FieldType;

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// Text of a deck inside a line of markdown.
std::string code_text(std::string_view text) {
  std::string result = "`";
  for (const char c : text.substr(0, 200)) result += c == '`' || static_cast<unsigned char>(c) < ' ' ? '\'' : c;
  return result + "`";
}

json markdown(std::string text, const json& range) {
  return {{"contents", {{"kind", "markdown"}, {"value", std::move(text)}}}, {"range", range}};
}

/// What a field may hold.
std::string_view type_of(const Field& field) {
  using keyword::IdKind;
  if (field.type == FieldType::text) return "text";
  if (field.type == FieldType::real) return "number";
  switch (field.id) {
    case IdKind::node:
      return "id of a node";
    case IdKind::element:
      return "id of an element";
    case IdKind::part:
      return "id of a part";
    case IdKind::material:
      return "id of a material or an equation of state";
    case IdKind::set:
      return "id of a set";
    case IdKind::function:
      return "id of a curve, table or function";
    case IdKind::define:
      return "id of a *DEFINE keyword";
    case IdKind::other:
      return "id";
    case IdKind::plain:
      return "whole number";
  }
  return "";
}

/// The default of a field of a contact, where it is not zero; empty: not known.
std::string default_of(const Keyword& keyword, const Field& field) {
  if (!keyword.name.starts_with("CONTACT_") || model::parse_contact_name(keyword.name).kind == nullptr) return {};
  const auto& defaults = audit::portability_table().defaults;
  const auto found = defaults.find(field.name);
  return found != defaults.end() ? fmt::format("{:g}", found->second) : std::string();
}

/// The value of a field that is not written as a number.
std::string value_text(const keyword::Card& card, std::size_t at, const Scope& scope, Diagnostics& said) {
  const std::string_view written = card.written(at);
  if (!keyword::is_parameter_reference(written)) return {};
  if (!scope.whole()) return "its deck has not been read";
  const double value = card.real(at);
  if (said.has_errors()) return said.sorted().front().message;
  return fmt::format("{:.15g}", value);
}

std::string surface_word(std::int64_t type) {
  constexpr std::array words{"a set of segments",
                             "a set of shells",
                             "a set of parts",
                             "a part",
                             "a set of nodes",
                             "all",
                             "all parts but those of a set",
                             "branches"};
  return type >= 0 && type < 8 ? words[static_cast<std::size_t>(type)] : "";
}

/// "part 3 "door" (parts.k, line 12)": what an id names.
std::string named(const Question& question, const Symbol& symbol) {
  const bool of_mesh = symbol.kind == Kind::node || symbol.kind == Kind::element;
  if (of_mesh) return {};  // found on demand: go to definition
  const auto found = find_definition(question.deck, symbol);
  if (!found) return fmt::format("{} {} is not defined in the files that are known", name_of(symbol.kind), symbol.id);
  const std::string title = found->title.empty() ? "" : " " + code_text(found->title);
  return fmt::format("{} {}{}, {} line {}", name_of(symbol.kind), symbol.id, title,
                     std::filesystem::path(found->file.path).filename().string(), found->at.line + 1);
}

json hover_field(const Question& question, const CardLine& at, Place place) {
  const std::string_view line = question.text().line(place.line);
  const Scope& scope = question.file().scope;
  const keyword::Block block = scope.block(*at.keyword);
  Diagnostics said;
  const keyword::Card card(scope.deck(), block, *at.layout, line, place.line + 1, said);
  std::size_t column = 0, commas = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(place.byte, line.size()); ++i) {
    column = line[i] == '\t' ? (column / 8 + 1) * 8 : column + 1;
    if (line[i] == ',') ++commas;
  }
  column = std::max<std::size_t>(column, place.byte);
  for (std::size_t i = 0; i < card.size(); ++i) {
    const keyword::Cell cell = card.cell(i);
    const bool inside = card.free_format() ? cell.slot == commas || (cell.slot < commas && i + 1 == card.size() &&
                                                                     at.layout->fields[i].type == FieldType::text)
                                           : column >= cell.column && column < cell.column + cell.width;
    if (!inside) continue;
    const Field& field = at.layout->fields[i];
    if (field.name == "unused") return nullptr;
    std::string text = fmt::format("**{}**, {} of *{}\n\n", upper(field.name), called(*at.layout), at.keyword->name);
    text += card.free_format()
                ? fmt::format("value {} of the line, {}\n\n", cell.slot + 1, type_of(field))
                : fmt::format("columns {}–{}, {}\n\n", cell.column + 1, cell.column + cell.width, type_of(field));
    const std::string_view written = card.written(i);
    const std::string standard = default_of(*at.keyword, field);
    if (written.empty())
      text += standard.empty() ? "blank\n" : fmt::format("blank: the default {}\n", standard);
    else if (const std::string value = value_text(card, i, scope, said); !value.empty())
      text += fmt::format("{} = {}\n", code_text(written), value);
    else
      text += fmt::format("{}\n", code_text(written));
    if (!written.empty() && !standard.empty()) text += fmt::format("\ndefault {}\n", standard);
    if (field.name == "surfatyp" || field.name == "surfbtyp")
      if (const std::string word = surface_word(card.integer(i)); !word.empty()) text += fmt::format("\n{}\n", word);
    for (const Occurrence& each : occurrences(question.file(), at, line, place.line)) {
      const auto begin = static_cast<std::size_t>(written.data() - line.data());
      if (written.empty() || each.begin < begin || each.end > begin + written.size() || each.definition) continue;
      if (each.symbol.kind == Kind::parameter) continue;
      if (const std::string what = named(question, each.symbol); !what.empty()) text += "\n" + what + "\n";
    }
    const std::size_t begin = written.empty() ? place.byte : static_cast<std::size_t>(written.data() - line.data());
    return markdown(std::move(text), range_in(line, place.line, begin, begin + written.size(), question.encoding));
  }
  return nullptr;
}

std::string_view word_of(model::Treatment treatment) {
  switch (treatment) {
    case model::Treatment::one_way:
      return "one way: nodes of surface A against segments of surface B";
    case model::Treatment::two_way:
      return "two ways: each surface's nodes against the other's segments";
    case model::Treatment::single_surface:
      return "one surface against itself";
    case model::Treatment::none:
      return "";
  }
  return "";
}

std::string about_contact(std::string_view name) {
  const model::ContactName contact = model::parse_contact_name(name);
  if (contact.kind == nullptr) return {};
  std::string text = fmt::format("contact type {}", model::printed(contact.kind->code, contact.kind->offset));
  if (const std::string_view treatment = word_of(contact.kind->treatment); !treatment.empty())
    text += fmt::format(", {}", treatment);
  if (contact.kind->breaks())
    text += "; ties until they fail";
  else if (contact.kind->ties())
    text += "; ties nodes to segments";
  return text + "\n\n";
}

json hover_keyword(const Question& question, const Keyword& keyword) {
  std::string text = fmt::format("***{}**\n\n", keyword.name);
  if (keyword.name.starts_with("CONTACT_")) text += about_contact(keyword.name);
  if (keyword::standing_of(keyword.name) != keyword::Standing::known) {
    const model::UnknownKeyword unknown{keyword.name, {}, 1, false};
    text += model::describe(unknown, model::nearest_keyword(unknown)) + "\n\n";
  }
  const CardOrder order = card_order(question.text(), keyword);
  const auto list = [&text](const std::vector<const CardLayout*>& cards, std::string_view behind) {
    for (const CardLayout* card : cards) {
      if (card == nullptr) continue;
      text += fmt::format("- {}{}:", called(*card), behind);
      for (const Field& field : card->fields)
        if (field.name != "unused") text += " " + upper(field.name);
      text += "\n";
    }
  };
  list(order.head, "");
  list(order.cycle, order.cycle.size() > 1 || !order.head.empty() ? ", repeated" : "");
  if (order.head.empty() && order.cycle.empty()) text += "its cards are not known here\n";
  const std::string_view line = question.text().line(keyword.line);
  return markdown(std::move(text), range_in(line, keyword.line, 0, line.size(), question.encoding));
}

}  // namespace

json hover(const Question& question, Place place) {
  const CardLine at = card_at(question.text(), *question.file().outline, place.line);
  if (at.keyword == nullptr) return nullptr;
  if (place.line == at.keyword->line) return hover_keyword(question, *at.keyword);
  return at.layout == nullptr ? json() : hover_field(question, at, place);
}

}  // namespace gapcheck::app::lsp
