#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/start.hpp"

namespace gapcheck::solver {

/// What a run of a deck starts with.
struct Start {
  StartReport report;
  std::vector<Vector> x;  ///< coordinates by node
};

/// Prepares a run of the deck as `run` does, follows its contacts through the first cycle, and reports what they did to
/// the geometry of the deck. A deck that `run` refuses is followed as far as possible: without the keywords that are
/// not calculated, else through the initialisation of its contacts alone; StartReport::refused says why. `surfaces`: of
/// this model. What the run would warn of goes to `diagnostics`.
[[nodiscard]] Start follow_start(const keyword::Deck& deck, const model::Model& model, contact::SurfaceStore& surfaces,
                                 Diagnostics& diagnostics);

}  // namespace gapcheck::solver
