#pragma once
#include <vector>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/build/build_rigid.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/mass_scaling.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Adds the thick shells of a deck (*ELEMENT_TSHELL, *SECTION_TSHELL) to a structure, or to the rigid bodies of their
/// parts (`rigid`: by part). A failure names what is missing or absurd.
[[nodiscard]] SolverStatus add_thick_shells(const model::Model& model, const MassScaling& scaling,
                                            std::vector<RigidPart>& rigid, Structure& structure,
                                            Diagnostics& diagnostics);

}  // namespace gapcheck::solver
