#pragma once
#include <string>
#include <string_view>

#include "keyword/deck.hpp"

namespace gapcheck::keyword {

/// The body of a block with the fields of LS-OPT's templates replaced, as LS-OPT does before the solver reads the deck:
/// `<<name>>`, `<<name:10>>` (right-aligned in so many columns), `<<name:i8>>` (a whole number) and expressions in
/// place of the name. Without a width the columns of the field itself are kept. Comments stay as they are, and so does
/// text in `<< >>` with blanks. Fields without a value become references to unread_parameter; they are reported.
[[nodiscard]] std::string with_template_fields(const Deck& deck, const Block& block, Diagnostics& diagnostics);

}  // namespace gapcheck::keyword
