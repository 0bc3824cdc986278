#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "records/report.hpp"
#include "report/baseline/baseline.hpp"

namespace gapcheck::report {

/// What one rule has found in all decks of a call. The views live as long as the reports.
struct RuleCount {
  std::string_view id, rule;           ///< "GC101", "initial-penetration"
  Severity severity = Severity::note;  ///< the gravest of its findings
  std::size_t decks = 0;               ///< with findings
  std::size_t findings = 0;            ///< without those that are left out on purpose
  BaselineCounts baseline;             ///< of decks that have one
};

/// The rules that have found something, or of whose findings some are gone: the gravest first, then those of most
/// decks, then by id.
[[nodiscard]] std::vector<RuleCount> rule_counts(std::span<const Report> reports);

}  // namespace gapcheck::report
