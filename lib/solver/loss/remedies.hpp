#pragma once
#include <span>

#include "records/expected_contact.hpp"
#include "solver/loss/judge_impacts.hpp"

namespace gapcheck::solver {

/// The margin that a remedy should give.
inline constexpr double wanted_margin = 2;

/// Sets what would give a row the wanted margin: `all`: the impacts of the run, `row`: positions of those of one
/// contact and two parts. `step`: of the run.
void find_remedies(std::span<const Impact> all, std::span<const std::size_t> row, double step, ExpectedContact& result);

}  // namespace gapcheck::solver
