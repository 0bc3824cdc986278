#pragma once
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "records/report.hpp"
#include "results/log/run_log.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// What the run found when it initialised its contacts, as records, and the surfaces' time steps (Report::predicted).
/// `surfaces`: of the run's model.
[[nodiscard]] Report run_report(const Run& run, contact::SurfaceStore& surfaces);

/// The contact definitions as d3hsp echoes them.
[[nodiscard]] std::vector<results::ContactDefinition> contact_definitions(const model::Model& model,
                                                                          contact::SurfaceStore& surfaces);

/// The 100 smallest steps of the elements.
[[nodiscard]] std::vector<results::ElementStep> element_steps(const model::Model& model,
                                                              const contact::ElementSizes& sizes);

}  // namespace gapcheck::solver
