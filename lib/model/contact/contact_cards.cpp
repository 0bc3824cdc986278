#include "model/contact/contact_cards.hpp"

#include <algorithm>
#include <cctype>

#include "base/number.hpp"

namespace gapcheck::model {
namespace {

using keyword::CardLayout;
using keyword::FieldType;

/// The types with one card of their own; the first entry that the name holds counts.
struct OwnCard {
  std::string_view token, card;
};
constexpr OwnCard own_cards[] = {
    {"CONTACT_TIEBREAK_NODES", "TIEBREAK_NODES"},
    {"CONTACT_TIEBREAK_SURFACE", "TIEBREAK_SURFACE"},
    {"_TIEBREAK", "TIEBREAK"},
    {"CONTACT_ERODING", "ERODING"},
    {"_INTERFERENCE", "INTERFERENCE"},
    {"CONTACT_CONSTRAINT", "CONSTRAINT"},
    {"CONTACT_RIGID", "RIGID"},
    {"_COMPOSITE", "COMPOSITE"},
    {"_LUBRICATION", "COMPOSITE"},
    {"_CONTRACTION_JOINT", "CONTRACTION_JOINT"},
    {"_TIED", "TIED"},
};

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
  // What a parameter or an expression stands for is found when the field is read.
  if (text.empty() || keyword::is_parameter_reference(text)) return true;
  if (field == nullptr) return parse_real(text) == 0.0;
  if (field->type == FieldType::integer) return parse_integer(text).has_value();
  return field->type == FieldType::text || parse_real(text).has_value();
}

}  // namespace

const CardLayout& contact_card_layout(std::string_view card) { return keyword::card_layout("CONTACT", card); }

const CardLayout* type_card(const ContactName& name) {
  switch (name.extra) {
    case ExtraCards::none:
    case ExtraCards::own:
      return nullptr;
    case ExtraCards::tiebreak:
    case ExtraCards::tiebreak_damping:
      return &contact_card_layout("TIEBREAK");
    case ExtraCards::tiebreak_user:
      return &contact_card_layout("TIEBREAK_USER");
    case ExtraCards::tied_weld:
      return &contact_card_layout("TIED_WELD1");
    case ExtraCards::drawbead:
    case ExtraCards::drawbead_initialize:
      return &contact_card_layout("DRAWBEAD1");
    case ExtraCards::one:
      break;
  }
  const auto own = std::find_if(std::begin(own_cards), std::end(own_cards),
                                [&](const OwnCard& entry) { return name.bare.find(entry.token) != std::string::npos; });
  return own == std::end(own_cards) ? nullptr : &contact_card_layout(own->card);
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
