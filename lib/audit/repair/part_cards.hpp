#pragma once
#include <cstdint>
#include <map>

#include "audit/repair/card_fields.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// OPTT by part id: in the card of *PART_CONTACT, which plain *PART becomes for these parts. Errors: a part whose
/// keyword has other options.
[[nodiscard]] Status write_part_thickness(CardFields& fields, const model::Model& model,
                                          const std::map<std::int64_t, double>& thickness);

/// T1 … T4 by section id in *SECTION_SHELL.
[[nodiscard]] Status write_section_thickness(CardFields& fields, const model::Model& model,
                                             const std::map<std::int64_t, double>& thickness);

}  // namespace gapcheck::audit
