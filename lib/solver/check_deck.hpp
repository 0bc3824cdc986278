#pragma once
#include "base/diagnostic.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Numbers of a deck that make a run meaningless: TSSFAC, SLSFAC, SFS or SFM below zero (springs that pull) are a
/// failure. Contacts that do nothing, because one side has no nodes or no segments, are reported in `diagnostics`.
/// `surfaces`: of this model.
[[nodiscard]] SolverStatus check_deck(const model::Model& model, contact::SurfaceStore& surfaces,
                                      Diagnostics& diagnostics);

}  // namespace gapcheck::solver
