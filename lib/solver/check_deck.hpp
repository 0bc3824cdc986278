#pragma once
#include <optional>

#include "base/diagnostic.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Numbers of a deck with which no run makes sense: TSSFAC, SLSFAC, SFS or SFM below zero (springs that pull) are a
/// failure. Contacts that do nothing, as one side has no nodes or no segments, are named in `diagnostics`.
/// `surfaces`: of this model.
[[nodiscard]] std::optional<Failure> check_deck(const model::Model& model, contact::SurfaceStore& surfaces,
                                                Diagnostics& diagnostics);

}  // namespace gapcheck::solver
