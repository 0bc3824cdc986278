#pragma once
#include <string>
#include <string_view>

#include "keyword/card.hpp"
#include "model/contact/contact_kind.hpp"

namespace gapcheck::model {

/// Layout of a card of *CONTACT: "card1", "MPP1", "ERODING".
[[nodiscard]] const keyword::CardLayout& contact_card_layout(std::string_view card);

/// Layout of the card that a type of contact has after card 3; nullptr: none.
[[nodiscard]] const keyword::CardLayout* type_card(TypeCards cards);

/// A card in words: "card 4 (ISYM, EROSOP, IADJ)".
[[nodiscard]] std::string card_words(const keyword::CardLayout& layout);

/// False if the next line of the reader cannot be the card: it has a fraction or text where the card has a whole
/// number, text where it has a number, or a nonzero value where the card has no field.
[[nodiscard]] bool has_form(const keyword::CardReader& reader, const keyword::CardLayout& layout);

}  // namespace gapcheck::model
