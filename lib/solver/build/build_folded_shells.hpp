#pragma once
#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/element/shell.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// NFAIL1 or NFAIL4 of *CONTROL_SHELL for the shells of a part; PSNFAIL limits them to the parts of a set. A failure
/// names a PSNFAIL that is not defined.
[[nodiscard]] SolverResult<FoldedShell> folded_shells(const model::Model& model, PartIndex part,
                                                      const model::Section& section, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
