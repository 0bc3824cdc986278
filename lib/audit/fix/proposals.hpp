#pragma once
#include <vector>

#include "contact/initial.hpp"
#include "model/model.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// Most pairs of parts for which a thickness is searched: each may cost two initialisations of its contact.
inline constexpr std::size_t most_thickness_trials = 20;

/// For each contact and pair of parts with penetrations, what else would remove them: SST and MST of the contact if
/// only these parts penetrate in it (the value of GC308), OPTT of both parts, thickness of their sections if that is
/// what counts, no contact between them, or IGNORE; with the keyword lines to add or change. OPTT is found by search:
/// with it nothing penetrates between the parts, and nothing new elsewhere in the contact. Only the first
/// most_thickness_trials pairs are searched. `state`: of the original deck, with nodes not moved. By contact and parts.
/// Changes the model's thicknesses on the way and restores them.
[[nodiscard]] std::vector<FixProposal> propose(model::Model& model, const contact::InitialState& state);

}  // namespace gapcheck::audit
