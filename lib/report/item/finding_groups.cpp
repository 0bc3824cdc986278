#include "report/item/finding_groups.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "report/item/causes.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/item.hpp"

namespace gapcheck::report {
namespace {

/// Severity, rule, contact (position and id), part, part of the element, reason of ties.
using GroupKey = std::tuple<Severity, std::string_view, std::uint32_t, std::int64_t, std::int64_t, std::int64_t, int>;

/// Groups as they come up.
class Groups {
 public:
  /// `counted`: the findings that are new or worse, in no order; others do not stand for what follows from them.
  Groups(const Report& report, std::unordered_set<const Finding*> counted)
      : report_(report), causes_(report), counted_(std::move(counted)) {
    for (std::uint32_t i = 0; i < report.contacts.size(); ++i) position_.emplace(report.contacts[i].id, i);
  }

  void add(const Penetration& record) {
    // Neighbours in the list mostly belong to the same group.
    const bool same = last_record_ != nullptr && last_record_->kind == record.kind &&
                      last_record_->contact == record.contact && last_record_->part == record.part &&
                      last_record_->element_part == record.element_part &&
                      last_of_record_->severity == severity_of(report_, record);
    last_record_ = &record;
    if (!same)
      last_of_record_ = &group_of(rule_of(report_, record), record.contact, 0, record.part, record.element_part, -1);
    FindingGroup& group = *last_of_record_;
    ++group.things;
    if (group.deepest == nullptr || record.depth > group.deepest->depth) group.deepest = &record;
  }

  void add(const TieFailure& failure) {
    FindingGroup& group =
        group_of(rule_of(report_, failure), failure.contact, 0, failure.part, 0, static_cast<int>(failure.reason));
    ++group.things;
    group.reason = failure.reason;
    if (group.widest == nullptr || failure.distance > group.widest->distance) group.widest = &failure;
  }

  void add(const Finding& finding) {
    const Finding* cause = causes_.of(finding);
    if (cause != nullptr && counted_.contains(cause)) return void(following_[cause] += finding.count);
    const auto found = position_.find(finding.contact);
    const std::uint32_t contact = finding.contact != 0 && found != position_.end() ? found->second : no_position;
    const RuleIdentity rule{finding.id, finding.rule, finding.severity, "", Need::model, finding.consequence};
    FindingGroup& group = group_of(rule, contact, finding.contact, finding.part, finding.element_part, -1);
    group.things += finding.count;
    if (group.first == nullptr) group.first = &finding;
    of_finding_[&finding] = &group;
  }

  [[nodiscard]] std::vector<FindingGroup> gravest_first() {
    for (const auto& [cause, number] : following_)
      if (const auto group = of_finding_.find(cause); group != of_finding_.end()) group->second->following += number;
    std::vector<FindingGroup> list;
    for (const auto& [key, group] : groups_) list.push_back(group);
    std::stable_sort(list.begin(), list.end(), graver);
    return list;
  }

 private:
  /// `contact_id`: only needed where the report has no such contact.
  FindingGroup& group_of(const RuleIdentity& rule, std::uint32_t contact, std::int64_t contact_id, std::int64_t part,
                         std::int64_t element_part, int reason) {
    if (contact < report_.contacts.size()) contact_id = report_.contacts[contact].id;
    const auto [at, fresh] =
        groups_.try_emplace({rule.severity, rule.id, contact, contact_id, part, element_part, reason});
    FindingGroup& group = at->second;
    if (!fresh) return group;
    group.id = rule.id, group.rule = rule.name, group.consequence = rule.consequence, group.severity = rule.severity;
    group.contact_position = contact;
    group.contact = contact_id;
    group.part = part, group.element_part = element_part;
    return group;
  }

  /// What the group weighs among those of its rule: depth or separation where there is one, otherwise the number.
  static double weight(const FindingGroup& group) {
    if (group.deepest != nullptr) return group.deepest->depth;
    if (group.widest != nullptr) return group.widest->distance;
    return static_cast<double>(group.things);
  }
  static bool graver(const FindingGroup& a, const FindingGroup& b) {
    if (a.severity != b.severity) return a.severity > b.severity;
    if ((a.following > 0) != (b.following > 0)) return a.following > 0;
    if (a.id != b.id) return a.id < b.id;
    return weight(a) > weight(b);
  }

  const Report& report_;
  Causes causes_;
  std::unordered_set<const Finding*> counted_;
  std::unordered_map<std::int64_t, std::uint32_t> position_;  // of a contact's id; the first of equal ones
  std::map<GroupKey, FindingGroup> groups_;
  const Penetration* last_record_ = nullptr;
  FindingGroup* last_of_record_ = nullptr;  // its group
  std::unordered_map<const Finding*, FindingGroup*> of_finding_;
  std::unordered_map<const Finding*, std::uint64_t> following_;
};

}  // namespace

std::vector<FindingGroup> finding_groups(const Report& report) {
  const std::size_t records = report.penetrations.size() + report.tie_failures.size();
  const auto counts = [&](std::size_t number) { return state_of(report, number) != BaselineState::unchanged; };
  std::unordered_set<const Finding*> counted;
  for (std::size_t i = 0; i < report.findings.size(); ++i)
    if (report.findings[i].key != 0 && counts(records + i)) counted.insert(&report.findings[i]);
  Groups groups(report, std::move(counted));
  std::size_t number = 0;
  const auto add = [&](const auto& list) {
    for (const auto& each : list)
      if (counts(number++)) groups.add(each);
  };
  add(report.penetrations), add(report.tie_failures), add(report.findings);
  return groups.gravest_first();
}

std::size_t number_of(const Report& report, const FindingGroup& group) {
  const std::size_t ties = report.penetrations.size(), others = ties + report.tie_failures.size();
  if (group.deepest != nullptr) return static_cast<std::size_t>(group.deepest - report.penetrations.data()) + 1;
  if (group.widest != nullptr) return ties + static_cast<std::size_t>(group.widest - report.tie_failures.data()) + 1;
  return others + static_cast<std::size_t>(group.first - report.findings.data()) + 1;
}

}  // namespace gapcheck::report
