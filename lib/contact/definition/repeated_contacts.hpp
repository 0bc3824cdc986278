#pragma once
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// By contact: the first one with the same cards, which finds the same penetrations as long as no node moves; none: it
/// repeats no other. Only contacts that no *CONTACT_EXCLUDE_INTERACTION names can repeat others.
[[nodiscard]] std::vector<ContactIndex> repeated_contacts(const model::Model& model);

}  // namespace gapcheck::contact
