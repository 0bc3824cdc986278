#pragma once
#include <string_view>

#include "results/curves/binout_row.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::results {

/// Adds one state of a branch to a run: glstat, rcforc, sleout, matsum, nodout, and those of history_files. False: the
/// state lacks its time or the values of all ids.
[[nodiscard]] bool add_binout_state(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row,
                                    RunResults& run);

}  // namespace gapcheck::results
