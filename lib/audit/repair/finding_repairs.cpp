#include "audit/repair/finding_repairs.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "audit/repair/repair_trial.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit {
namespace {

RepairParts parts_of_ids(std::int64_t contact, std::int64_t part, std::int64_t other) {
  return {contact, std::min(part, other), std::max(part, other)};
}

std::int64_t contact_id(const Report& report, std::uint32_t position) {
  return position < report.contacts.size() ? report.contacts[position].id : 0;
}

std::optional<RepairTarget> target_of(const Report& report, const Penetration& record) {
  if (!to_be_repaired(record.kind)) return std::nullopt;
  return RepairTarget{RepairTarget::Kind::penetrations,
                      parts_of_ids(contact_id(report, record.contact), record.part, record.element_part)};
}

std::optional<RepairTarget> target_of(const Report& report, const TieFailure& failure) {
  if (failure.reason != TieReason::too_far) return std::nullopt;
  return RepairTarget{RepairTarget::Kind::ties, {contact_id(report, failure.contact), 0, 0}};
}

std::optional<RepairTarget> target_of(const Finding& finding) {
  if (finding.id == rule::tie_reach::definition.identity.id)
    return RepairTarget{RepairTarget::Kind::ties, {finding.contact, 0, 0}};
  if (finding.id == rule::penetration_free_at::definition.identity.id)
    return RepairTarget{RepairTarget::Kind::thickness,
                        parts_of_ids(finding.contact, finding.part, finding.element_part)};
  return std::nullopt;
}

bool is_for(const RepairPair& pair, const RepairTarget& target) {
  if (target.kind == RepairTarget::Kind::ties) return pair.of_ties && pair.parts.contact == target.parts.contact;
  return !pair.of_ties && pair.parts == target.parts;
}

bool makes_thinner(RepairKind kind) {
  return kind == RepairKind::part_thickness || kind == RepairKind::contact_thickness || kind == RepairKind::sections;
}

}  // namespace

std::optional<RepairTarget> repair_target(const Report& report, std::size_t number) {
  std::size_t at = number - 1;  // 0: beyond all of them
  if (at < report.penetrations.size()) return target_of(report, report.penetrations[at]);
  at -= report.penetrations.size();
  if (at < report.tie_failures.size()) return target_of(report, report.tie_failures[at]);
  at -= report.tie_failures.size();
  return at < report.findings.size() ? target_of(report.findings[at]) : std::nullopt;
}

std::vector<const Repair*> repairs_for(const RepairPlan& plan, const RepairTarget& target) {
  std::vector<const Repair*> list;
  for (const RepairPair& pair : plan.pairs) {
    if (!is_for(pair, target)) continue;
    for (const Repair& repair : pair.repairs)
      if (!repair.lines.empty() && (target.kind != RepairTarget::Kind::thickness || makes_thinner(repair.kind)))
        list.push_back(&repair);
  }
  return list;
}

FindingRepairs solving_repairs(const RepairPlan& plan, const Report& report) {
  std::set<const Repair*> solving;
  for (const RepairPair& pair : plan.pairs)
    for (const Repair& repair : pair.repairs)
      if (pair.tried && repair.outcome.solves()) solving.insert(&repair);
  FindingRepairs repairs;
  std::set<RepairTarget> known;
  const std::size_t count = report.penetrations.size() + report.tie_failures.size() + report.findings.size();
  for (std::size_t number = 1; number <= count && !solving.empty(); ++number) {
    const std::optional<RepairTarget> target = repair_target(report, number);
    if (!target || !known.insert(*target).second) continue;
    std::vector<const Repair*> list = repairs_for(plan, *target);
    std::erase_if(list, [&](const Repair* repair) { return !solving.contains(repair); });
    if (!list.empty()) repairs.emplace(number, std::move(list));
  }
  return repairs;
}

}  // namespace gapcheck::audit
