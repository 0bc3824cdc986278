#pragma once
#include <cstdint>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/element/hourglass.hpp"
#include "solver/element/spotweld.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// The limits of material 100 if they are in range; none for other materials. `written`: as the deck has it. Source:
/// LS-DYNA Keyword User's Manual, Vol. II, *MAT_SPOTWELD.
[[nodiscard]] SolverResult<WeldLimits> weld_limits(const model::Material& written);

/// Bricks of spotwelds need faces of three or four corners on both sheets; a failure names the one that has not.
[[nodiscard]] SolverStatus check_weld_brick(const model::Model& model, std::uint32_t solid);

/// Warns that a one-point brick whose hourglass control is no stiffness bends and twists freely, where MRR, MSS or MTT
/// counts.
void name_free_bending(const model::Model& model, const model::Material& written, const WeldLimits& limits,
                       const Hourglass& hourglass, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
