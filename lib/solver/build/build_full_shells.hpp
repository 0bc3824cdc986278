#pragma once
#include "model/model.hpp"
#include "solver/build/build.hpp"
#include "solver/element/shell.hpp"

namespace gapcheck::solver {

/// ELFORM 5 and 9: membranes with one point in the plane, and with 2 x 2.
[[nodiscard]] bool membrane(const model::Section& section);

/// ELFORM 16, and forms that are calculated as it (−16, 6, 7, 18, 20, 21, 26): four points in the plane.
[[nodiscard]] bool full_shell(const model::Section& section);

/// Makes a part's shells fully integrated; its triangles are what ESORT of *CONTROL_SHELL says. Warns about an
/// hourglass control other than type 8, about ELFORM other than 16 and ESORT = 2.
void make_full(const model::Model& model, PartIndex index, const model::Section& section, ShellProperties& properties,
               Diagnostics& diagnostics);

/// A failure where the shell at this position is a deformable fully integrated one that cannot be calculated: a
/// triangle with an ESORT other than 0, 1 and 2, or a quad with corners at `x` that is folded over at one of its four
/// points.
[[nodiscard]] SolverStatus check_full_shell(const model::Model& model, const model::Shells& shells, std::uint32_t i,
                                            const std::array<Vector, 4>& x);

}  // namespace gapcheck::solver
