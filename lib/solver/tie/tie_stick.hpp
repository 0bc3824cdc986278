#pragma once
#include "contact/definition/contact_type.hpp"
#include "solver/interface/touch.hpp"
#include "solver/tie/tie_spring.hpp"
#include "solver/tie/tie_strengths.hpp"

namespace gapcheck::solver {

/// OPTION 1 and 3 of tiebreaks, and those below zero: nodes that come into contact later stick too, for ever or until
/// they fail.
[[nodiscard]] bool ties_stick(const model::Contact& contact);

/// The tie of a node that has come into contact: it acts from the next cycle on, with the force that contact now has on
/// the node where that is, and without any across.
[[nodiscard]] TieSpring stuck_spring(const model::Contact& contact, const Tie& tie, const Touch& touch,
                                     const TieStrengths& strengths, const State& state);

}  // namespace gapcheck::solver
