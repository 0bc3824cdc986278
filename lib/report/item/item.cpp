#include "report/item/item.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/fingerprint.hpp"

namespace gapcheck::report {
namespace {

void set_rule(const RuleIdentity& rule, Item& item) {
  item.id = rule.id;
  item.rule = rule.name;
  item.severity = rule.severity;
}

void set_contact(const Report& report, std::uint32_t position, Item& item) {
  if (position >= report.contacts.size()) return;
  item.contact_position = position;
  item.contact = report.contacts[position].id;
}

void set_place(const Report& report, std::uint32_t file, std::uint32_t line, Item& item) {
  if (line == 0 || file >= report.files.size()) return;
  item.file = report.files[file];
  item.line = line;
}

/// Visits the entries of the three lists until `visit` returns false.
template <class Lists, class Visit>
void hand_over(const Report& report, const Lists& lists, const Visit& visit) {
  for (const Penetration& record : lists.penetrations)
    if (!visit(item_of(report, record))) return;
  for (const TieFailure& failure : lists.tie_failures)
    if (!visit(item_of(report, failure))) return;
  std::unordered_map<std::int64_t, std::uint32_t> position;  // of a contact's id; the first of equal ones
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) position.emplace(report.contacts[i].id, i);
  for (const Finding& finding : lists.findings) {
    Item item = item_of(finding);
    if (const auto found = position.find(finding.contact); finding.contact != 0 && found != position.end())
      item.contact_position = found->second;
    if (!visit(std::move(item))) return;
  }
}

}  // namespace

Item item_of(const Report& report, const Penetration& record) {
  Item item;
  set_rule(rule_of(report, record), item);
  set_contact(report, record.contact, item);
  set_place(report, record.file, record.line, item);
  fmt::memory_buffer message;
  append_message(record, message);
  item.message = fmt::to_string(message);
  item.node = record.node;
  item.part = record.part;
  item.element = record.element;
  item.element_part = record.element_part;
  const bool deck = report.source == "deck";
  if (deck || record.depth > 0) item.penetration = record.depth;
  if (record.contact_distance > 0) item.contact_distance = record.contact_distance;
  if (deck || !record.original.isZero()) item.position = record.original;
  // The solver does not list nodes of the edge zone; what it does with edges is not known.
  if (record.kind != PenetrationKind::edge_zone && record.kind != PenetrationKind::edge)
    item.outcome = name(record.outcome);
  item.fingerprint = fingerprint(record, item.contact);
  return item;
}

Item item_of(const Report& report, const TieFailure& failure) {
  Item item;
  set_rule(rule_of(report, failure), item);
  set_contact(report, failure.contact, item);
  set_place(report, failure.file, failure.line, item);
  item.message = message(failure);
  item.node = failure.node;
  item.part = failure.part;
  item.segment_size = failure.segment_size;
  item.position = failure.position;
  item.outcome = name(failure.reason);
  item.fingerprint = fingerprint(failure, item.contact);
  return item;
}

Item item_of(const Finding& finding) {
  Item item;
  item.id = finding.id;
  item.rule = finding.rule;
  item.severity = finding.severity;
  item.message = finding.message;
  item.contact = finding.contact;
  item.node = finding.node;
  item.part = finding.part;
  item.element = finding.element;
  item.element_part = finding.element_part;
  item.penetration = finding.penetration;
  item.contact_distance = finding.contact_distance;
  item.position = finding.point;
  item.file = finding.file;
  item.line = finding.line;
  item.count = finding.count;
  item.fingerprint = fingerprint(finding);
  return item;
}

std::optional<BaselineState> state_of(const Report& report, std::size_t number) {
  if (!report.baseline || number >= report.baseline->states.size()) return std::nullopt;
  return report.baseline->states[number];
}

void for_each_item(const Report& report, const std::function<bool(const Item&)>& visit) {
  std::size_t number = 0;
  hand_over(report, report, [&](Item item) {
    item.state = state_of(report, number);
    item.number = ++number;
    return visit(item);
  });
}

void for_each_ignored(const Report& report, const std::function<bool(const Item&)>& visit) {
  const Ignored& ignored = report.ignored;
  std::size_t number = 0;
  hand_over(report, ignored, [&](Item item) {
    if (report.baseline && number < report.baseline->ignored_states.size())
      item.state = report.baseline->ignored_states[number];
    item.ignored = &ignored.sources[ignored.source[number++]];
    return visit(item);
  });
}

std::string link_to(const Report& report, std::size_t number) {
  return report.page.empty() ? "" : fmt::format("{}#f{}", report.page, number);
}

std::string describe(const IgnoreSource& source) {
  std::string text = source.line == 0 ? source.file : fmt::format("{}:{}", source.file, source.line);
  return source.reason.empty() ? text : text + ": " + shortened(source.reason, reason_shown);
}

std::vector<ItemGroup> item_groups(const Report& report, std::size_t top) {
  std::map<std::pair<std::uint32_t, std::string_view>, ItemGroup> groups;
  const auto group_of = [&](const Item& item) -> ItemGroup& {
    ItemGroup& group = groups[{item.contact_position, item.id}];
    group.contact_position = item.contact_position;
    group.id = item.id;
    group.rule = item.rule;
    return group;
  };
  for_each_item(report, [&](const Item& item) {
    ItemGroup& group = group_of(item);
    if (!item.counts()) {
      ++group.known;
      return true;
    }
    group.severity = std::max(group.severity, item.severity);
    if (group.items++ < top) group.shown.push_back(item);
    return true;
  });
  for_each_ignored(report, [&](const Item& item) {
    ItemGroup& group = group_of(item);
    ++group.ignored;
    if (group.sources.size() < ignore_sources_shown &&
        std::find(group.sources.begin(), group.sources.end(), item.ignored) == group.sources.end())
      group.sources.push_back(item.ignored);
    return true;
  });
  std::vector<ItemGroup> list;
  list.reserve(groups.size());
  for (auto& [key, group] : groups) list.push_back(std::move(group));
  return list;
}

}  // namespace gapcheck::report
