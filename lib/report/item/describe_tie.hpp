#pragma once
#include <array>
#include <string>
#include <string_view>

#include "records/report.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::report {

/// All reasons, in the order of the views.
inline constexpr std::array tie_reasons{TieReason::sep,       TieReason::offset,    TieReason::too_far,
                                        TieReason::too_short, TieReason::not_found, TieReason::rigslav,
                                        TieReason::rigmast,   TieReason::conflict};

/// GC201 for nodes that stay untied (an error where a node set names them), GC202 for ties with a separation that stays,
/// GC204 for those that are moved.
[[nodiscard]] RecordRule rule_of(const TieFailure& failure);
/// The same with the severity that the report gives it.
[[nodiscard]] RecordRule rule_of(const Report& report, const TieFailure& failure);

/// What happened to the node: "on no segment (untied)".
[[nodiscard]] std::string_view what_happened(TieReason reason);

/// One sentence on a record that a person understands. Plain ASCII without quotes and backslashes.
[[nodiscard]] std::string message(const TieFailure& failure);

}  // namespace gapcheck::report
