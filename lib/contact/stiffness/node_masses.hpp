#pragma once
#include <cstdint>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"

namespace gapcheck::contact {

/// Lumped mass of every node: shells ρ A t, solids and thick shells ρ V, beams ρ A L in equal shares to their nodes,
/// and *ELEMENT_MASS. Rigid parts count like others. Elements whose mass is not a number are left out. One pass,
/// linear. `printed`: as in the solver's printed contact time step, where each listed corner has an equal share, and so
/// the third of a triangle two: triangles of rigid parts, and solids other than tetrahedra and wedges by ELFORM
/// (contact rules, section 12.3).
[[nodiscard]] std::vector<double> node_masses(const model::Model& model, const ElementSizes& sizes,
                                              bool printed = false);

/// Mass per volume of a part; plies of *PART_COMPOSITE, or points of its *INTEGRATION_SHELL, together. 0 without a
/// material.
[[nodiscard]] double density(const model::Model& model, PartIndex part);
/// That of a shell, which may have plies of its own.
[[nodiscard]] double shell_density(const model::Model& model, std::uint32_t shell);

}  // namespace gapcheck::contact
