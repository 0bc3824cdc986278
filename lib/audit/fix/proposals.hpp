#pragma once
#include <vector>

#include "contact/initial.hpp"
#include "model/model.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// Pairs of parts for which a thickness is searched: each may cost two initialisations of its contact.
inline constexpr std::size_t most_thickness_trials = 20;

/// For each contact and pair of parts with penetrations what else would end them: SST and MST of the contact where only
/// these parts penetrate in it (the value of GC308), OPTT of both parts, thickness of their sections where that is what
/// counts, no contact between them, or IGNORE; with the keyword lines to be added or changed. OPTT is searched: with it
/// nothing penetrates between the parts, and nothing else in the contact that does not now. Only the first
/// most_thickness_trials pairs are. `state`: of the deck as it is, with nodes that stay. By contact and parts. Changes
/// the model's thicknesses as it goes, and puts them back.
[[nodiscard]] std::vector<FixProposal> propose(model::Model& model, const contact::InitialState& state);

}  // namespace gapcheck::audit
