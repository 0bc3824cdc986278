#pragma once
#include <vector>

#include "contact/pair/hit.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// Drops hits behind solid facets whose node lies outside the body: in front of a nearer outer face that has no
/// segment, because shells cover it or the contact does not name it; or, in two-surface contacts, a node of the body
/// itself that none of its elements has inside. `search`: finds the faces near the nodes. Costs
/// nothing if no hit lies behind a solid facet.
void drop_outside(const PairScene& scene, const CandidateSearch& search, std::vector<Hit>& hits);

}  // namespace gapcheck::contact
