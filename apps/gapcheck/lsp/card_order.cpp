#include "lsp/card_order.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "base/number.hpp"
#include "model/contact/contact_cards.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::app::lsp {
namespace {

using keyword::CardLayout;
using keyword::KeywordLayout;
using Words = std::vector<std::string_view>;
using Rows = std::span<const std::string_view>;

bool begins_with_any(std::string_view name, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [name](std::string_view beginning) {
    return name.starts_with(beginning) && (name.size() == beginning.size() || name[beginning.size()] == '_');
  });
}

bool has(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The words of a name behind those of the layout that it has.
Words words_behind(std::string_view name, const KeywordLayout& layout) {
  Words words = model::words_of(name.substr(std::min(layout.name.size() + 1, name.size())));
  std::erase(words, std::string_view());
  return words;
}

/// A whole number in a line of fields of ten columns; 0 if there is none.
std::int64_t number_in(std::string_view line, std::size_t field, keyword::Format format) {
  const bool free = line.find(',') != std::string_view::npos;
  const std::size_t width = format == keyword::Format::long_fields ? 20 : 10;
  if (!free) return parse_integer(line.size() > field * width ? line.substr(field * width, width) : "").value_or(0);
  for (; field > 0; --field) line.remove_prefix(std::min(line.find(','), line.size() - 1) + 1);
  return parse_integer(line.substr(0, line.find(','))).value_or(0);
}

/// The layout of a title line.
const CardLayout* text_line() { return &keyword::card_layout("TITLE", "card1"); }

/// As lib/model/read/read_contacts.cpp reads them.
CardOrder contact_order(std::string_view name, keyword::Format format, Rows rows) {
  const model::ContactName contact = model::parse_contact_name(name);
  CardOrder order;
  if (contact.kind == nullptr) return order;
  const auto add = [&order](std::string_view card) { order.head.push_back(&model::contact_card_layout(card)); };
  const auto row = [&] { return order.head.size() < rows.size() ? rows[order.head.size()] : std::string_view(); };
  const auto add_unknown = [&order](std::int64_t count) {
    for (; count > 0 && order.head.size() < deciding_rows; --count) order.head.push_back(nullptr);
  };
  if (contact.options.id) add("ID");
  if (contact.options.mpp) {
    add("MPP1");
    if (trimmed(row()).starts_with('&')) add("MPP2");
  }
  for (const char* card : {"card1", "card2", "card3"}) add(card);
  if (const CardLayout* own = model::type_card(contact.kind->cards)) {
    const std::int64_t first = number_in(row(), 0, format);
    order.head.push_back(own);
    using model::TypeCards;
    switch (contact.kind->cards) {
      case TypeCards::tiebreak_damping:
        add("TIEBREAK_DAMPING");
        [[fallthrough]];
      case TypeCards::tiebreak:
        if ((std::abs(first) == 13 || std::abs(first) == 14) && !contact.options.mortar) {
          add("TIEBREAK_G1C");
          add("TIEBREAK_G2C");
        }
        break;
      case TypeCards::tiebreak_user:
        add("TIEBREAK_USER_UP1");
        add("TIEBREAK_USER_UP9");
        break;
      case TypeCards::tied_weld:
      case TypeCards::draw_bead:
      case TypeCards::draw_bead_initialize:
        order.checked = false;
        return order;  // as many lines as a field says
      default:
        break;
    }
  }
  if (contact.options.thermal) add("THERMAL");
  if (contact.options.thermal_friction) add("THERMAL_FRICTION");
  if (contact.options.ortho_friction) add_unknown(4);
  for (const char* card : {"A", "B", "C", "D", "E", "F", "G"}) add(card);
  order.checked = true;
  return order;
}

/// As lib/model/read/read_parts.cpp reads them.
CardOrder part_order(const Words& words) {
  CardOrder order;
  const auto add = [&order](std::string_view keyword, std::string_view card) {
    order.cycle.push_back(&keyword::card_layout(keyword, card));
  };
  order.cycle.push_back(text_line());
  if (has(words, "COMPOSITE")) {
    add(has(words, "TSHELL") ? "PART_COMPOSITE_TSHELL" : "PART_COMPOSITE", "card2");
    if (has(words, "CONTACT")) add("PART_CONTACT", "card3");
    order.head = std::move(order.cycle);
    order.cycle.clear();
    return order;
  }
  add("PART", "card1.2");
  order.checked = true;
  if (has(words, "INERTIA")) {
    for (const char* card : {"card3", "card4", "card5"}) add("PART_INERTIA", card);
    order.checked = false;  // one more where IRCS = 1
  }
  if (has(words, "REPOSITION")) order.cycle.push_back(nullptr);
  if (has(words, "CONTACT")) add("PART_CONTACT", "card3");
  for (const char* word : {"PRINT", "ATTACHMENT", "FIELD"})
    if (has(words, word)) order.cycle.push_back(nullptr);
  return order;
}

/// The second card of *SECTION_BEAM depends on ELFORM.
const CardLayout* second_beam_card(std::int64_t elform) {
  const char* card = elform == 6 ? "card6" : elform == 9 ? "card7" : "card2";
  if (elform == 2 || elform == 3 || elform == 12 || elform == 13) card = "card3";
  return &keyword::card_layout("SECTION_BEAM", card);
}

/// Only what the keyword's cards always are.
CardOrder section_order(std::string_view name, const KeywordLayout& layout, bool title, keyword::Format format,
                        Rows rows) {
  CardOrder order;
  std::vector<const CardLayout*>& cards = order.cycle;
  if (title) cards.push_back(text_line());
  if (const CardLayout* first = layout.card("card1")) cards.push_back(first);
  const std::size_t at = title ? 1 : 0;
  if (layout.name == "SECTION_BEAM")
    cards.push_back(second_beam_card(at < rows.size() ? number_in(rows[at], 1, format) : 0));
  else if (const CardLayout* second = layout.card("card2"); second != nullptr && layout.name != "SECTION_SOLID")
    cards.push_back(second);
  order.checked = layout.name == "SECTION_SHELL" || layout.name == "SECTION_SOLID";
  // With titles it is seen by the text whether another section follows; other forms have more cards.
  if (title || layout.name == "SECTION_BEAM" || name != layout.name) order.head = std::move(order.cycle), cards = {};
  return order;
}

/// One line `eid pid n1 … n8`, or `eid pid` and a line of nodes for each element.
CardOrder solid_order(const KeywordLayout& layout, keyword::Format format, Rows rows) {
  CardOrder order;
  const std::size_t two_fields = format == keyword::Format::long_fields ? 40 : format == keyword::Format::i10 ? 20 : 16;
  const std::string_view first = rows.empty() ? std::string_view() : rows.front();
  const bool free = first.find(',') != std::string_view::npos;
  const bool alone = free ? std::count(first.begin(), first.end(), ',') <= 1
                          : trimmed(first).empty() || first.find_last_not_of(" \t") < two_fields;
  const CardLayout* whole = layout.card("card1_legacy");
  if (!alone && whole != nullptr)
    order.cycle = {whole};
  else
    order.cycle = {layout.card("card1"), layout.card("card2")};
  order.checked = !alone;
  return order;
}

/// Keywords whose last card comes again and again.
bool repeats_last(std::string_view name) {
  return begins_with_any(name, {"SET", "DEFINE_CURVE", "DEFINE_TABLE", "DEFINE_TRANSFORMATION", "INTEGRATION_SHELL",
                                "CONSTRAINED_LINEAR_GLOBAL", "CONSTRAINED_LINEAR_LOCAL"});
}

/// Keywords that the model reads by these cards, in this order.
bool is_sure(std::string_view name) {
  return begins_with_any(name, {"NODE", "ELEMENT_SHELL", "ELEMENT_BEAM", "ELEMENT_MASS", "SET", "DEFINE_CURVE",
                                "DEFINE_BOX", "BOUNDARY_SPC", "LOAD_NODE", "CONTROL_TERMINATION", "CONTROL_TIMESTEP",
                                "CONTROL_CONTACT", "CONTROL_ACCURACY", "CONTROL_ENERGY", "CONSTRAINED_RIGID_BODIES",
                                "CONSTRAINED_EXTRA_NODES", "INITIAL_VELOCITY_NODE", "MAT_ELASTIC", "MAT_RIGID"});
}

/// The cards that every form of a keyword has: card1, card2 … or card1.1, card1.2.
std::vector<const CardLayout*> plain_cards(const KeywordLayout& layout) {
  std::vector<const CardLayout*> cards;
  for (const CardLayout& card : layout.cards)
    if (card.name.starts_with("card") && card.name.find('_') == std::string::npos) cards.push_back(&card);
  return cards;
}

CardOrder plain_order(std::string_view name, const KeywordLayout& layout, const Words& words) {
  const std::vector<const CardLayout*> cards = plain_cards(layout);
  CardOrder order;
  order.checked = is_sure(name);
  if (has(words, "TITLE")) order.head.push_back(text_line());
  if (const CardLayout* id = layout.card("ID"); id != nullptr && has(words, "ID")) order.head.push_back(id);
  if (repeats_last(name) && cards.size() > 1) {
    // Of *SET_…_GENERAL the second card has the general form.
    const bool set = name.starts_with("SET");
    order.head.insert(order.head.end(), cards.begin(), set ? cards.begin() + 1 : cards.end() - 1);
    order.cycle = {set ? cards[1] : cards.back()};
    return order;
  }
  order.head.insert(order.head.end(), cards.begin(), cards.end());
  const bool grouped = !cards.empty() && cards.front()->name == "card1.1";
  const bool motion = begins_with_any(name, {"BOUNDARY_PRESCRIBED_MOTION"});
  if (motion) order.head.resize(order.head.size() - (cards.size() - 1));  // the second depends on DOF
  if (cards.size() == 1 || grouped || motion) std::swap(order.head, order.cycle);
  // The third line of such elements depends on their corners, and lines of options are between those of elements.
  if (name.starts_with("ELEMENT") && cards.size() > 1) order.checked = false;
  return order;
}

}  // namespace

const CardLayout* CardOrder::at(std::size_t row) const {
  if (row < head.size()) return head[row];
  return cycle.empty() ? nullptr : cycle[(row - head.size()) % cycle.size()];
}

std::size_t CardOrder::least(std::size_t row) const {
  if (row < head.size()) return row;
  return cycle.empty() ? head.size() : head.size() + (row - head.size()) % cycle.size();
}

const KeywordLayout* layout_of(std::string_view name) {
  const KeywordLayout* layout = keyword::find_layout_of(name);
  if (layout == nullptr || layout->name == name) return layout;
  if (begins_with_any(name, {"PART", "CONSTRAINED_JOINT"})) return layout;
  if (begins_with_any(layout->name, {"CONTACT"}) && model::parse_contact_name(name).kind != nullptr) return layout;
  // *MAT_ELASTIC_… of another law is not *MAT_ELASTIC.
  const Words words = words_behind(name, *layout);
  const bool options = std::all_of(words.begin(), words.end(), [](std::string_view word) {
    return word == "TITLE" || word == "ID" || word == "COLLECT";
  });
  return options ? layout : nullptr;
}

CardOrder card_order(std::string_view name, keyword::Format format, Rows rows) {
  if (begins_with_any(name, {"CONTACT"}) && model::parse_contact_name(name).kind != nullptr)
    return contact_order(name, format, rows);
  const KeywordLayout* layout = layout_of(name);
  if (layout == nullptr) {
    // Whatever the law, the number of a material is the first field.
    CardOrder material;
    if (!begins_with_any(name, {"MAT"}) || begins_with_any(name, {"MAT_ADD"})) return material;
    static const CardLayout first{"card1", {{"mid", 0, 10, keyword::FieldType::integer, keyword::IdKind::material}}};
    if (name.ends_with("_TITLE")) material.head.push_back(text_line());
    material.head.push_back(&first);
    return material;
  }
  const Words words = words_behind(name, *layout);
  if (begins_with_any(name, {"PART"}) && !begins_with_any(name, {"PART_MOVE", "PART_DUPLICATE", "PART_MODES"}))
    return part_order(model::words_of(name));
  if (begins_with_any(name, {"SECTION_SHELL", "SECTION_SOLID", "SECTION_BEAM", "SECTION_TSHELL"}))
    return section_order(name, *layout, has(words, "TITLE"), format, rows);
  if (layout->name == "ELEMENT_SOLID") return solid_order(*layout, format, rows);
  return plain_order(name, *layout, words);
}

CardOrder card_order(std::string_view name, keyword::Format format, const Text& text, Text::Spot data) {
  std::vector<std::string_view> rows;
  text.for_each_line(data, [&rows](std::string_view line) {
    if (line.starts_with('*')) return false;
    if (!line.starts_with('$')) rows.push_back(line);
    return rows.size() < deciding_rows;
  });
  return card_order(name, format, rows);
}

CardOrder card_order(const Text& text, const Keyword& keyword) {
  return card_order(keyword.name, keyword.format, text, text.start_of(keyword.line + 1));
}

std::string called(const CardLayout& layout) {
  if (layout.name.starts_with("card")) return "card " + layout.name.substr(4);
  return layout.name.size() == 1 ? "card " + layout.name : "card of " + layout.name;
}

}  // namespace gapcheck::app::lsp
