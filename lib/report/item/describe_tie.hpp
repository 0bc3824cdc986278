#pragma once
#include <string>
#include <string_view>

#include "records/record_rules.hpp"
#include "records/report.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::report {

/// The rule that the node is a finding of, with the severity that the report gives it.
[[nodiscard]] RuleIdentity rule_of(const Report& report, const TieFailure& failure);

/// What happened to the node: "on no segment (untied)".
[[nodiscard]] std::string_view what_happened(TieReason reason);

/// One readable sentence about a record. Plain ASCII without quotes and backslashes.
[[nodiscard]] std::string message(const TieFailure& failure);

}  // namespace gapcheck::report
