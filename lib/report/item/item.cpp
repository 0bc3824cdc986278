#include "report/item/item.hpp"

#include <algorithm>
#include <map>
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

template <class Lists>
Items::Items(const Report& report, const Lists& lists, const Ignored* ignored)
    : report_(&report),
      penetrations_(lists.penetrations),
      tie_failures_(lists.tie_failures),
      findings_(lists.findings),
      ignored_(ignored) {
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) position_.emplace(report.contacts[i].id, i);
}

Items::Items(const Report& report) : Items(report, report, nullptr) {}

Items Items::ignored(const Report& report) { return Items(report, report.ignored, &report.ignored); }

Item Items::entry(std::size_t i) const {
  if (i < penetrations_.size()) return item_of(*report_, penetrations_[i]);
  i -= penetrations_.size();
  if (i < tie_failures_.size()) return item_of(*report_, tie_failures_[i]);
  const Finding& finding = findings_[i - tie_failures_.size()];
  Item item = item_of(finding);
  if (const auto found = position_.find(finding.contact); finding.contact != 0 && found != position_.end())
    item.contact_position = found->second;
  return item;
}

Item Items::operator[](std::size_t i) const {
  Item item = entry(i);
  if (ignored_ == nullptr) {
    item.state = state_of(*report_, i);
    item.number = i + 1;
    return item;
  }
  if (report_->baseline && i < report_->baseline->ignored_states.size())
    item.state = report_->baseline->ignored_states[i];
  item.ignored = &ignored_->sources[ignored_->source[i]];
  return item;
}

namespace {

void visit_all(const Items& items, const std::function<bool(const Item&)>& visit) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!visit(items[i])) return;
}

}  // namespace

void for_each_item(const Report& report, const std::function<bool(const Item&)>& visit) {
  visit_all(Items(report), visit);
}

void for_each_ignored(const Report& report, const std::function<bool(const Item&)>& visit) {
  visit_all(Items::ignored(report), visit);
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
