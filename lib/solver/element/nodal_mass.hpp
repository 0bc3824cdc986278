#pragma once
#include <array>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::solver {

/// Masses of the shells, solids and thick shells of some parts (`wanted`: by part), lumped to their nodes in equal
/// shares; by node. Incomplete elements and elements without mass do not count.
[[nodiscard]] std::vector<double> nodal_masses(const model::Model& model, const std::vector<bool>& wanted);

/// The initial mean thickness of a shell; `own`: at its nodes if it has one, 0 = the section's.
[[nodiscard]] double mean_thickness(const model::Section& section, const std::array<double, 4>* own);

}  // namespace gapcheck::solver
