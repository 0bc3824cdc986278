#pragma once
#include <memory>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/condition/springs.hpp"
#include "solver/state/failure.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The discrete elements of a deck with the materials S01 to S05, S07 and S08, once all masses are complete. A missing
/// part, section, material or curve and any other material is a failure; further settings of a section, and elements
/// with an orientation vector, are reported in `diagnostics` and not calculated. Null if there are none.
[[nodiscard]] SolverResult<std::unique_ptr<Springs>> build_springs(const model::Model& model,
                                                                   const Structure& structure,
                                                                   Diagnostics& diagnostics);

}  // namespace gapcheck::solver
