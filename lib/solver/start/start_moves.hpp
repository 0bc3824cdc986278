#pragma once
#include <span>
#include <vector>

#include "contact/initial.hpp"
#include "records/start.hpp"
#include "solver/interface/contact_state.hpp"

namespace gapcheck::solver {

/// One move of a node before the first step, with positions in the model.
struct NodeStep {
  ContactIndex contact;
  NodeIndex node;
  PartIndex part = none<PartIndex>, other_part = none<PartIndex>;  ///< of the node, of the segment; none: not known
  Vector from = Vector::Zero(), to = Vector::Zero();
  StartCause cause = StartCause::shot;
  [[nodiscard]] Vector way() const { return to - from; }
};

/// The moves of the initialisation, by contact, read off its records: where each node was when a contact judged it, and
/// where it is in the end. Moves by contacts are in their records; any other change between two records is that of a
/// tie. `initial`: of this model, with all penetrations listed.
[[nodiscard]] std::vector<NodeStep> initial_steps(const model::Model& model, const contact::InitialState& initial);

/// The moves of the first cycle in the same form.
[[nodiscard]] std::vector<NodeStep> cycle_steps(std::span<const ShotNode> shot);

/// What a coordinate of this size means at most: decks are written with single precision or less. Shorter moves are
/// rounding.
[[nodiscard]] double rounding_at(const Vector& x);

}  // namespace gapcheck::solver
