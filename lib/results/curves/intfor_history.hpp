#pragma once
#include "base/diagnostic.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::results {

/// Reads the interface force database "intfor" in the directory of a run, if there is one: the largest pressure and the
/// force on each side of each contact go to RunResults::entities. One that cannot be read is a warning.
void read_intfor(RunResults& run, Diagnostics& diagnostics);

}  // namespace gapcheck::results
