#pragma once
#include <optional>

#include "records/expected_contact.hpp"
#include "solver/loss/flight.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// What will meet and be lost in a run that has calculated its first cycle, all moving on along straight lines from
/// `start`, the velocities before it. Contacts are those of the run, with its springs, release depths and masses; each
/// pair of parts is judged as if nothing but their contact acted on them. Nothing: nothing moves.
[[nodiscard]] std::optional<ExpectedContacts> expect_contacts(Run& run, const StartMotion& start);

/// The deck has something that may move nodes at the start; without it nothing is searched.
[[nodiscard]] bool may_move(const model::Model& model);

}  // namespace gapcheck::solver
