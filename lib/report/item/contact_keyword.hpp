#pragma once
#include <string>

#include "records/report.hpp"

namespace gapcheck::report {

/// The contact's type as a keyword without `*CONTACT_`: from the deck if known, otherwise from the solver's code ("a3"
/// gives "AUTOMATIC_SURFACE_TO_SURFACE"). Several keywords share some codes; the most common one is given. Unknown
/// codes give "?".
[[nodiscard]] std::string contact_keyword(const ContactSummary& contact);

}  // namespace gapcheck::report
