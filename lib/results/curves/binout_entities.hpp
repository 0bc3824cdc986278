#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "results/curves/binout_row.hpp"
#include "results/curves/entity_history.hpp"

namespace gapcheck::results {

/// The files that such branches belong to.
inline constexpr std::array<std::string_view, 8> entity_files{"secforc", "spcforc", "bndout", "rwforc",
                                                              "rbdout",  "swforc",  "elout",  "deforc"};

/// True for a branch whose states are entities: "secforc", "bndout/velocity/nodes".
[[nodiscard]] bool is_entity_branch(std::string_view branch);

/// Adds one state of such a branch; its columns are those of which the branch's first state has values. False: the
/// state lacks its time or the values of all ids.
[[nodiscard]] bool add_entity_state(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row,
                                    std::vector<EntityHistory>& histories);

}  // namespace gapcheck::results
