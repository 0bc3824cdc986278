#pragma once
#include "base/diagnostic.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::results {

/// Reads the binout files in the directory of a run (binout, binout0000, binout0000%001, …) and fills in glstat,
/// rcforc, sleout, matsum and nodout where the run has no text file of that name, which is no longer missing then; and
/// secforc, spcforc, bndout, rwforc, rbdout, swforc, elout, deforc and jntforc. A file that is not a binout is a
/// warning. A state without its time, or without the values of all ids, is left out, and so is a last one with fewer
/// arrays than the one before it; `diagnostics` count these. `nodes`: nodout and
/// secforc and so on as well.
void read_binout(RunResults& run, bool nodes, Diagnostics& diagnostics);

}  // namespace gapcheck::results
