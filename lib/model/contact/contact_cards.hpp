#pragma once
#include <string>
#include <string_view>

#include "keyword/card.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::model {

/// Layout of a card of *CONTACT: "card1", "MPP1", "ERODING".
[[nodiscard]] const keyword::CardLayout& contact_card_layout(std::string_view card);

/// Layout of the card that a type of contact has behind card 3; nullptr: it has none.
[[nodiscard]] const keyword::CardLayout* type_card(const ContactName& name);

/// A card in words: "card 4 (ISYM, EROSOP, IADJ)".
[[nodiscard]] std::string card_words(const keyword::CardLayout& layout);

/// False if the next line of the reader cannot be the card: it has a fraction or a text where the card has a whole
/// number, a text where it has a number, or something else than zero where the card has no field.
[[nodiscard]] bool has_form(const keyword::CardReader& reader, const keyword::CardLayout& layout);

}  // namespace gapcheck::model
