#pragma once
#include <array>
#include <string_view>

#include "results/curves/binout_row.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::results {

/// The files whose branches are read into the histories of RunResults.
inline constexpr std::array<std::string_view, 10> history_files{"secforc", "spcforc", "bndout", "rwforc",  "rbdout",
                                                                "swforc",  "elout",   "deforc", "jntforc", "abstat"};

/// True for a branch of one of them that is read: "secforc", "bndout/velocity/nodes".
[[nodiscard]] bool is_history_branch(std::string_view branch);

/// Adds one state of such a branch to the history that its text file would give. False: the state lacks its time or
/// the values of all ids.
[[nodiscard]] bool add_history_state(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row,
                                     RunResults& run);

}  // namespace gapcheck::results
