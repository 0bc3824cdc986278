#pragma once
#include <string>

#include "solver/run.hpp"

namespace gapcheck::app {

/// Summary of a finished run: end, cycles, energies, and one line per contact.
[[nodiscard]] std::string run_summary(const solver::Run& run, solver::RunEnd end);

/// Counters and times of the run, for --stats.
[[nodiscard]] std::string run_statistics(const solver::Run& run);

}  // namespace gapcheck::app
