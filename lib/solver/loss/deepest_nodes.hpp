#pragma once
#include <set>
#include <vector>

#include "solver/loss/judge_impacts.hpp"

namespace gapcheck::solver {

/// Groups of impacts with a margin whose nodes do not stay with the face that they meet: where they are deepest another
/// segment of the body is nearer, so that that one counts.
[[nodiscard]] std::set<std::size_t> groups_that_leave_faces(const ImpactScene& scene,
                                                            const std::vector<Impact>& impacts);

}  // namespace gapcheck::solver
