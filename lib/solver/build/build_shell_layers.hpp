#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"
#include "solver/element/shell.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// What messages call the owner of layers, and where it is.
struct LayeredBy {
  std::string name;
  model::Place place;
};

/// One point in the middle of each ply, with the ply's share of the thickness (Keyword User's Manual, *PART_COMPOSITE,
/// *ELEMENT_SHELL_COMPOSITE). A failure names a ply without material or thickness, or whose material is not calculated
/// in plies.
[[nodiscard]] SolverStatus set_plies(const model::Model& model, const std::vector<model::Ply>& plies, double thickness,
                                     const LayeredBy& owner, ShellProperties& properties);

/// The points of the *INTEGRATION_SHELL that the section names (QR/IRID below zero). A failure names a missing rule,
/// counts, places, weights or parts without meaning, or what is not calculated.
[[nodiscard]] SolverStatus set_rule(const model::Model& model, const model::Part& part, const model::Section& section,
                                    ShellProperties& properties);

}  // namespace gapcheck::solver
