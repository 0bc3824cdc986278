#pragma once
#include <vector>

#include "base/diagnostic.hpp"
#include "contact/initial.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"
#include "solver/interpolation/follower.hpp"
#include "solver/state/failure.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The nodes of *CONSTRAINED_INTERPOLATION, for a structure with all its conditions; `surfaces` and `initial` are of
/// the same model. Failures with keyword, file and line: what contradicts itself or the other conditions, nodes whose
/// motion the independent ones do not give, and what is not calculated: independent nodes of rigid bodies and welds,
/// with rotations that count, with conditions in local axes, that follow others, or that constraints tie or stop.
[[nodiscard]] SolverResult<std::vector<Follower>> find_followers(const model::Model& model,
                                                                 contact::SurfaceStore& surfaces,
                                                                 const contact::InitialState& initial,
                                                                 const Structure& structure, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
