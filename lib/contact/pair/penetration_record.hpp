#pragma once
#include "base/ids.hpp"
#include "contact/pair/hit.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// The record of a tracked node that penetrates a segment, and what the solver does to the node when it initialises the
/// contact: nothing where segments are judged (SOFT = 2, mortar: the state at the start is the one without force) and
/// outside every segment's band; a release beyond the release depth; otherwise outcome(). Source: contact rules,
/// sections 5, 7 and 12.
[[nodiscard]] Penetration penetration_record(const PairScene& scene, ContactIndex contact, const Hit& hit);

}  // namespace gapcheck::contact
