#include "model/contact/contact_cards.hpp"

#include <algorithm>
#include <cctype>

#include "base/number.hpp"

namespace gapcheck::model {
namespace {

using keyword::CardLayout;
using keyword::FieldType;

/// Eight fields of ten columns, none of them read as a number.
const CardLayout& texts() {
  static const CardLayout built = [] {
    CardLayout card{"texts", {}};
    for (std::uint16_t i = 0; i < 8; ++i)
      card.fields.push_back({"text", static_cast<std::uint16_t>(10 * i), 10, FieldType::text, keyword::IdKind::plain});
    return card;
  }();
  return built;
}

bool fits(std::string_view text, const keyword::Field* field) {
  // Parameters and expressions are resolved when the field is read.
  if (text.empty() || keyword::is_parameter_reference(text)) return true;
  if (field == nullptr) return parse_real(text) == 0.0;
  if (field->type == FieldType::integer) return parse_integer(text).has_value();
  return field->type == FieldType::text || parse_real(text).has_value();
}

}  // namespace

const CardLayout& contact_card_layout(std::string_view card) { return keyword::card_layout("CONTACT", card); }

const CardLayout* type_card(TypeCards cards) {
  switch (cards) {
    case TypeCards::none:
      return nullptr;
    case TypeCards::eroding:
      return &contact_card_layout("ERODING");
    case TypeCards::interference_card:
      return &contact_card_layout("INTERFERENCE");
    case TypeCards::constraint:
      return &contact_card_layout("CONSTRAINT");
    case TypeCards::rigid:
      return &contact_card_layout("RIGID");
    case TypeCards::composite:
      return &contact_card_layout("COMPOSITE");
    case TypeCards::contraction_joint:
      return &contact_card_layout("CONTRACTION_JOINT");
    case TypeCards::tied:
      return &contact_card_layout("TIED");
    case TypeCards::tiebreak:
    case TypeCards::tiebreak_damping:
      return &contact_card_layout("TIEBREAK");
    case TypeCards::tiebreak_user:
      return &contact_card_layout("TIEBREAK_USER");
    case TypeCards::tiebreak_nodes:
      return &contact_card_layout("TIEBREAK_NODES");
    case TypeCards::tiebreak_surface:
      return &contact_card_layout("TIEBREAK_SURFACE");
    case TypeCards::tied_weld:
      return &contact_card_layout("TIED_WELD1");
    case TypeCards::draw_bead:
    case TypeCards::draw_bead_initialize:
      return &contact_card_layout("DRAWBEAD1");
  }
  return nullptr;
}

std::string card_words(const CardLayout& layout) {
  std::string words;
  for (const keyword::Field& field : layout.fields) {
    if (field.name == "unused") continue;
    if (!words.empty()) words += ", ";
    for (const char c : field.name) words += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return "card 4 (" + words + ")";
}

bool has_form(const keyword::CardReader& reader, const CardLayout& layout) {
  // A line that is too long is reported when it is read.
  if (reader.peek().size() > keyword::Card::max_line) return true;
  const keyword::Card card = reader.peek(texts());
  for (std::size_t i = 0; i < texts().fields.size(); ++i) {
    const auto field = std::find_if(layout.fields.begin(), layout.fields.end(), [&](const keyword::Field& candidate) {
      return candidate.column == texts().fields[i].column && candidate.name != "unused";
    });
    if (!fits(card.text(i), field == layout.fields.end() ? nullptr : &*field)) return false;
  }
  return true;
}

}  // namespace gapcheck::model
