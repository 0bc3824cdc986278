#pragma once
#include <optional>
#include <variant>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// What the deck's keywords that are not read yet would say.
struct BuildSettings {
  Hourglass shell_hourglass, solid_hourglass;
  /// Coordinates of the nodes at the start, where they are not the deck's: those that the contacts' initialisation has
  /// left. Beside the model's nodes.
  const std::vector<Vector>* x = nullptr;
};

/// The solver's material: constants of the deck, yield curve resolved. The failure names the material.
[[nodiscard]] std::variant<Material, Failure> build_material(const model::Model& model,
                                                             const model::Material& material);

/// Names what the deck says about a material that build_material() leaves out: failure, VP, LCSR.
void name_what_is_not_calculated(const model::Model& model, const model::Material& material, Diagnostics& diagnostics);

/// The structure at rest that a model describes: shells, solids, beams, lumped masses and rigid bodies. Elements of other
/// kinds, and shell or solid formulations other than the one-point ones, are named in `diagnostics` (warnings); the
/// former are left out, the latter calculated as the element that is there. Elements without part, section or material,
/// materials that are not there and elements turned inside out are failures.
[[nodiscard]] std::variant<Structure, Failure> build_structure(const model::Model& model, const BuildSettings& settings,
                                                               Diagnostics& diagnostics);

}  // namespace gapcheck::solver
