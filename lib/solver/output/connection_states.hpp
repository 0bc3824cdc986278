#pragma once
#include <vector>

#include "results/history/airbag_states.hpp"
#include "results/history/joint_forces.hpp"
#include "results/history/spring_forces.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// Of the discrete springs and dampers that are calculated and whose PF asks for it, in the order of the elements.
[[nodiscard]] std::vector<results::SpringForce> spring_states(const Run& run);

/// Of the airbags that are calculated, in the order of the deck.
[[nodiscard]] std::vector<results::AirbagRow> airbag_states(const Run& run);

/// Of all joints, in deck order, in global axes.
[[nodiscard]] std::vector<results::JointForce> joint_states(const Run& run);

}  // namespace gapcheck::solver
