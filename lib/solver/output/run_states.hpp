#pragma once
#include <optional>
#include <vector>

#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "solver/output/node_areas.hpp"
#include "solver/output/part_masses.hpp"
#include "solver/output/run_record.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

// The contents of a run's text files at the observed time.

[[nodiscard]] results::GlobalState global_state(const Run& run);
/// By part of the model.
[[nodiscard]] std::vector<results::PartState> part_states(const Run& run, const PartMasses& masses);
/// Of the nodes of *DATABASE_HISTORY_NODE. Without `turns` rotations are zero.
[[nodiscard]] std::vector<results::NodeState> node_states(const Run& run, const NodeTurns* turns = nullptr);
/// For the calculated contacts, each once even if several sources contribute; `transducers`: including those, all in
/// deck order.
[[nodiscard]] std::vector<results::InterfaceState> interface_states(const Run& run, bool transducers);
/// By node and side the force and pressure of a contact: on the sides that SAPR and SBPR name, for all contacts if no
/// contact names one. Nodes without a force are left out. Nothing: the contact is not calculated, or must not be
/// printed.
[[nodiscard]] std::optional<std::vector<results::NodeForce>> node_forces(const Run& run, ContactIndex contact,
                                                                         const NodeAreas& areas);

}  // namespace gapcheck::solver
