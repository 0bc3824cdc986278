#pragma once
#include <span>
#include <vector>

#include "model/model.hpp"
#include "records/fix.hpp"
#include "records/penetration.hpp"

namespace gapcheck::audit {

/// For each contact and pair of parts with penetrations what else would end them: a smaller thickness (SST and MST of the contact where
/// only these parts penetrate in it, OPTT of the parts otherwise), no contact between them, or IGNORE; with the keyword lines
/// to be added or changed. `records`: of the deck as it is. By contact and parts.
[[nodiscard]] std::vector<FixProposal> propose(const model::Model& model, std::span<const Penetration> records);

}  // namespace gapcheck::audit
