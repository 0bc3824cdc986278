#pragma once
#include "model/model.hpp"
#include "solver/build/build.hpp"
#include "solver/element/shell.hpp"

namespace gapcheck::solver {

/// What the shells of a part share: formulation, integration through the thickness, thinning, hourglass control, bulk
/// viscosity, layers of a composite. Warns about formulations that are calculated as another one, and once about what
/// *CONTROL_SHELL and *CONTROL_ACCURACY ask for that is not calculated. `otherwise`: hourglass control where the deck
/// gives none. `layup`: the plies of *ELEMENT_SHELL_COMPOSITE that these shells have in place of what their part says.
[[nodiscard]] SolverResult<ShellProperties> shell_properties(const model::Model& model, PartIndex index,
                                                             const model::Section& section, Material material,
                                                             const Hourglass& otherwise, Diagnostics& diagnostics,
                                                             const model::Layup* layup = nullptr);

/// Warnings about fields of *CONTROL_SHELL, *CONTROL_ACCURACY and *CONTROL_BULK_VISCOSITY that have no effect.
void name_element_controls(const model::Model& model, Diagnostics& diagnostics);

/// Where the nodes of a shell lie, in half thicknesses from its mid-surface along the normal: NLOC, or OFFSET of
/// *ELEMENT_SHELL_OFFSET, which moves the mid-surface along the normal.
[[nodiscard]] double shell_reference(const model::Section& section, const double* offset, double thickness);

}  // namespace gapcheck::solver
