#pragma once
#include "scenes/scenes.hpp"

namespace gapcheck::bench {

/// Pairs of panels, turned at random, in the cells of a lattice: about 1,500 parts in 10^6 shells, with elements of 1
/// to 100. The smaller panel of every eighth pair penetrates the larger one. One single-surface contact has all parts;
/// up to 64 surface-to-surface contacts have a pair each. IGNORE = 1: nodes stay where they are.
SceneFacts write_vehicle(std::uint64_t shells, const DeckSink& sink);

}  // namespace gapcheck::bench
