#pragma once
#include <cstdint>
#include <span>

#include "base/diagnostic.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/fix.hpp"
#include "records/fix_proof.hpp"

namespace gapcheck::solver {

struct TrialSettings {
  double until = 0;          ///< end time; 0: that of the deck
  std::uint64_t cycles = 0;  ///< most cycles; 0: no limit
  bool leave_out = false;    ///< runs without what is not calculated; else a deck with such input is not run
};

/// Runs a deck without writing files and tells how its contacts start and what the run does to them. `surfaces`: of
/// this model. What a run would warn of goes to `diagnostics`.
[[nodiscard]] RunTrial try_run(const keyword::Deck& deck, const model::Model& model, contact::SurfaceStore& surfaces,
                               const TrialSettings& settings, Diagnostics& diagnostics);

/// The same for a deck as it is, and with some of its nodes where a correction puts them. `model`: of this deck; its
/// nodes have been moved afterwards. Local systems that nodes define stay as they are in the deck.
[[nodiscard]] FixProof prove_fix(const keyword::Deck& deck, model::Model& model, std::span<const MovedNode> moved,
                                 const TrialSettings& settings, Diagnostics& diagnostics);

/// The same for a deck as it is, and as a repair writes it. The models are those of the decks.
[[nodiscard]] FixProof prove_repair(const keyword::Deck& before, const model::Model& model_before,
                                    const keyword::Deck& after, const model::Model& model_after,
                                    const TrialSettings& settings, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
