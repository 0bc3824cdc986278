#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/node_move.hpp"
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
/// this model. Once the work is stopped, it ends somewhere on the way. What the run would warn of goes to
/// `diagnostics`.
[[nodiscard]] Start follow_start(const keyword::Deck& deck, const model::Model& model, contact::SurfaceStore& surfaces,
                                 Diagnostics& diagnostics);

/// What pages and grids show of a start.
struct ShownMoves {
  std::vector<gapcheck::NodeMove> moves;  ///< of all nodes that are not where the deck has them
  std::string said;                       ///< a sentence about them
};
[[nodiscard]] ShownMoves shown_moves(const model::Nodes& nodes, const Start& start);

}  // namespace gapcheck::solver
