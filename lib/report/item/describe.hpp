#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "records/record_rules.hpp"
#include "records/report.hpp"
#include "report/write/harmless.hpp"

namespace gapcheck::report {

/// The rule that a penetration record is a finding of, with the severity that the report gives it.
[[nodiscard]] RuleIdentity rule_of(const Report& report, PenetrationKind kind);
/// The same for this record: a note if its depth is within rounding.
[[nodiscard]] RuleIdentity rule_of(const Report& report, const Penetration& record);
/// Its severity alone.
[[nodiscard]] Severity severity_of(const Report& report, const Penetration& record);
/// The rule with the severity that the report gives it.
[[nodiscard]] RuleIdentity with_severity(const Report& report, RuleIdentity rule);

[[nodiscard]] std::string_view name(Severity severity);

/// Where the contact distance of a record comes from: "SST/MST", or "node: …, segment: …" if the sides differ. Appends
/// nothing if neither side is known. Plain ASCII without quotes and backslashes.
void append_cause(const Penetration& record, fmt::memory_buffer& out);

/// One readable sentence about a record. Plain ASCII without quotes and backslashes.
void append_message(const Penetration& record, fmt::memory_buffer& out);

/// The beginning of a text, `longest` bytes at most; whole characters of UTF-8.
[[nodiscard]] std::string_view beginning(std::string_view text, std::size_t longest);

/// The same as a copy, followed by "…" if something is left out.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t longest);

}  // namespace gapcheck::report
