#pragma once
#include <span>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "model/model.hpp"
#include "results/d3plot/d3plot.hpp"
#include "results/d3plot/d3plot_state.hpp"
#include "results/text/file_header.hpp"
#include "solver/output/part_masses.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Energies absorbed by the elements of one part: existing ones and failed ones.
struct PartEnergy {
  ElementEnergy present, eroded;
};
[[nodiscard]] std::vector<PartEnergy> part_energies(const model::Model& model, const Structure& structure);

/// Elements of the structure may fail, so plots say which exist.
[[nodiscard]] bool can_fail(const Structure& structure);

/// Parts with their titles, in the model's order.
[[nodiscard]] std::vector<results::LegendEntry> part_titles(const model::Model& model);

/// All contacts, and the nodes of *DATABASE_HISTORY_NODE.
[[nodiscard]] std::vector<results::LegendEntry> contact_titles(const model::Model& model);
[[nodiscard]] std::vector<results::LegendEntry> node_titles(const model::Model& model);

/// The model's mesh as in a d3plot: all elements whose nodes and part exist, nodes at their initial positions.
[[nodiscard]] results::D3plot plot_mesh(const model::Model& model, const std::vector<Vector>& x);

/// What a d3plot holds besides energies: positions, velocities (in the middle of the next step), stresses in global
/// axes, plastic strains, resultants and thickness of all shells and solids of plot_mesh(). Elements of rigid parts
/// have no stress.
[[nodiscard]] results::D3plotState plot_state(const model::Model& model, const Structure& structure,
                                              const contact::ElementSizes& sizes, std::span<const PartMotion> motion);

}  // namespace gapcheck::solver
