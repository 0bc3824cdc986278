#pragma once
#include <optional>
#include <vector>

#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "solver/output/part_masses.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

// What the text files of a run say at the time that is observed.

[[nodiscard]] results::GlobalState global_state(const Run& run);
/// By part of the model.
[[nodiscard]] std::vector<results::PartState> part_states(const Run& run, const PartMasses& masses);
/// Of the nodes of *DATABASE_HISTORY_NODE. Rotations are not followed: only angular velocities and accelerations.
[[nodiscard]] std::vector<results::NodeState> node_states(const Run& run);
/// Of the contacts that are calculated, each once however many sources have a part in it; `transducers`: of those too,
/// all in deck order.
[[nodiscard]] std::vector<results::InterfaceState> interface_states(const Run& run, bool transducers);
/// By node what a contact (position in Model::contacts) puts on it, and the greatest pressure: on the sides that SAPR
/// and SBPR name, of all contacts where no contact names one. Nodes without a force are left out. Nothing: the contact
/// is not calculated, or not to be printed.
[[nodiscard]] std::optional<std::vector<results::NodeForce>> node_forces(const Run& run, std::uint32_t contact);

}  // namespace gapcheck::solver
