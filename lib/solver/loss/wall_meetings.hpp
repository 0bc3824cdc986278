#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"
#include "records/expected_contact.hpp"
#include "solver/loss/flight.hpp"

namespace gapcheck::solver {

/// The first node of each part that reaches each flat rigid wall that stands still; by time. Others go to
/// `not_looked_at`. `x`: at the start, by node.
[[nodiscard]] std::vector<ExpectedWall> find_wall_meetings(const model::Model& model, const std::vector<Vector>& x,
                                                           const Flight& flight, double until,
                                                           std::vector<std::string>& not_looked_at);

}  // namespace gapcheck::solver
