#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::report {

/// Findings of one rule, equally severe, in one contact (or in none) and between one pair of parts: one line of the
/// short report. Lives as long as the report.
struct FindingGroup {
  std::string_view id, rule;     ///< "GC101", "initial-penetration"
  std::string_view consequence;  ///< of the rule; empty: not known
  Severity severity = Severity::note;
  std::uint32_t contact_position = no_position;  ///< in Report::contacts
  std::int64_t contact = 0;                      ///< id; 0: none
  std::int64_t part = 0, element_part = 0;       ///< 0: not known, or without a meaning for the rule
  std::uint64_t things = 0;                      ///< that are new or worse than the baseline
  std::uint64_t following = 0;                   ///< further things that follow from these
  // What represents the group, exactly one of them: the deepest record, the widest tie, the first finding.
  const Penetration* deepest = nullptr;
  const TieFailure* widest = nullptr;
  const Finding* first = nullptr;
  TieReason reason = TieReason::not_found;  ///< of ties
};

/// All groups with something new or worse: errors first; of equally severe ones first those that others follow from,
/// then by rule id, and within a rule the gravest first. Findings that follow from another one are in no group.
[[nodiscard]] std::vector<FindingGroup> finding_groups(const Report& report);

/// Item::number of what represents a group of this report.
[[nodiscard]] std::size_t number_of(const Report& report, const FindingGroup& group);

}  // namespace gapcheck::report
