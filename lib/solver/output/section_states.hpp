#pragma once
#include <vector>

#include "results/history/section_forces.hpp"
#include "solver/output/element_places.hpp"
#include "solver/output/section_cuts.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// The forces with which the elements of a section pull at its nodes, their moment about the section's centroid, and
/// the area of the section as it is now. Failed elements have neither.
[[nodiscard]] results::SectionState section_state(const Run& run, const ElementPlaces& places, const CutSection& cut);

/// Of all sections that are calculated, in deck order.
[[nodiscard]] std::vector<results::SectionState> section_states(const Run& run, const ElementPlaces& places,
                                                                const std::vector<CutSection>& cuts);

}  // namespace gapcheck::solver
