#pragma once
#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Values of deck keywords that are not read yet.
struct BuildSettings {
  Hourglass shell_hourglass, solid_hourglass;
  /// Initial coordinates of the nodes if they differ from the deck's: those after the contacts' initialisation.
  /// Parallel to the model's nodes.
  const std::vector<Vector>* x = nullptr;
};

/// The solver's material: constants of the deck, yield curve resolved. The failure names the material.
[[nodiscard]] SolverResult<Material> build_material(const model::Model& model, const model::Material& material);

/// Reports what build_material() leaves out of a material: failure, VP, LCSR.
void name_what_is_not_calculated(const model::Model& model, const model::Material& material, Diagnostics& diagnostics);

/// The structure at rest that a model describes: shells, solids, beams, lumped masses and rigid bodies. Elements of
/// other kinds, and shell or solid formulations other than the one-point ones, are reported in `diagnostics`
/// (warnings); the former are left out, the latter calculated as the available element. Elements without part, section
/// or material, missing materials and inverted elements are failures.
[[nodiscard]] SolverResult<Structure> build_structure(const model::Model& model, const BuildSettings& settings,
                                                      Diagnostics& diagnostics);

}  // namespace gapcheck::solver
