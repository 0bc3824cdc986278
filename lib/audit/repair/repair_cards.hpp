#pragma once
#include "audit/repair/deck_edits.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/repair.hpp"

namespace gapcheck::audit {

/// Writes what repairs set, except moves, into the cards of a deck: fields of cards that are there, cards that its
/// contacts lack, *PART_CONTACT in place of *PART, and keywords before *END. Everything else keeps its bytes.
/// `model`: of this deck. Errors, with file and line: a card that cannot be changed (a parameter, an include with a
/// transformation, a file that is included twice, a keyword with other cards).
[[nodiscard]] Status write_cards(const keyword::Deck& deck, const model::Model& model, const RepairSettings& settings,
                                 DeckEdits& edits);

}  // namespace gapcheck::audit
