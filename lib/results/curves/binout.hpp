#pragma once
#include <string>

#include "base/diagnostic.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::results {

/// Reads the binout files in the directory of a run (binout, binout0000, …) and fills in glstat, rcforc, sleout, matsum
/// and nodout where the run has no text file of that name; such a name is no longer missing. A file that is not a
/// binout is a warning. A state without its time, or without the values of all ids, is left out; `diagnostics` count
/// these. `nodes`: nodout as well.
void read_binout(RunResults& run, bool nodes, Diagnostics& diagnostics);

}  // namespace gapcheck::results
