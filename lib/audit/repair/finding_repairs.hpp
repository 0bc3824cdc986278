#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "records/repair_plan.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

/// What repairs of a finding are about.
struct RepairTarget {
  enum class Kind : std::uint8_t {
    penetrations,  ///< of two parts in a contact
    thickness,     ///< the same, but only those that make something thinner
    ties,          ///< nodes that a contact is to tie; without parts
  };
  Kind kind = Kind::penetrations;
  RepairParts parts;
  auto operator<=>(const RepairTarget&) const = default;
};

/// Of the finding with this number (report::Item::number: from 1, penetrations, ties, then the others); nothing where
/// repairs do not help.
[[nodiscard]] std::optional<RepairTarget> repair_target(const Report& report, std::size_t number);

/// The repairs of a plan for a target that write lines, in the order of the plan; valid as long as it. Some of them may
/// not solve anything (RepairOutcome::solves()).
[[nodiscard]] std::vector<const Repair*> repairs_for(const RepairPlan& plan, const RepairTarget& target);

/// Repairs by the number of the finding.
using FindingRepairs = std::map<std::size_t, std::vector<const Repair*>>;

/// The repairs that have been tried and solve their pair, each with the first finding of its target: once they are done
/// the others are gone too.
[[nodiscard]] FindingRepairs solving_repairs(const RepairPlan& plan, const Report& report);

}  // namespace gapcheck::audit
