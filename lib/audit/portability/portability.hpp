#pragma once
#include <vector>

#include "audit/portability/portability_table.hpp"
#include "base/ids.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/portability.hpp"

namespace gapcheck::audit {

/// Which keywords, options and fields of the contacts other programs do not read. A field is compared as the deck has
/// it: blank, zero and its default are no input. Of a contact whose keyword a program does not read neither options nor
/// fields are named. `contacts`: those to look at, ascending; all of them: exclusions between contacts too.
[[nodiscard]] Portability find_portability(const keyword::Deck& deck, const model::Model& model,
                                           const std::vector<ContactIndex>& contacts,
                                           const PortabilityTable& table = portability_table());

}  // namespace gapcheck::audit
