#pragma once
#include <cstdint>
#include <vector>

#include "contact/pair/pair.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// True if the solver turns the segments of a surface of this type itself when the run starts.
[[nodiscard]] bool solver_turns(const model::Controls& controls, std::int64_t surface_type);

/// Which oriented shell segments face the wrong way: by segment, true = against its node order. Empty if none is
/// flipped. The solver turns the segments of surfaces given by parts towards the other side (ORIEN of *CONTROL_CONTACT,
/// on by default; 2 also turns segment sets). gapcheck turns a part as a whole: to the side on which the majority of
/// the tracked nodes near it lie (near = within a segment's longer diagonal, projection on the face).
[[nodiscard]] std::vector<bool> flipped_segments(const PairScene& scene, const CandidateSearch& search);

}  // namespace gapcheck::contact
