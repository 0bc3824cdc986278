#include "results/log/log_collector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/ids.hpp"

namespace gapcheck::results {
namespace {

constexpr std::uint64_t default_message_limit = 50;

/// Brings the items into the order of `order` (positions of the items) without a second copy of them.
template <class Item>
void permute(std::vector<Item>& items, std::vector<std::uint32_t>& order) {
  for (std::uint32_t start = 0; start < order.size(); ++start) {
    if (order[start] == start) continue;
    Item first = std::move(items[start]);
    std::uint32_t at = start;
    while (order[at] != start) {
      const std::uint32_t next = order[at];
      items[at] = std::move(items[next]);
      order[at] = at;
      at = next;
    }
    items[at] = std::move(first);
    order[at] = at;
  }
}

/// Sorts large items by moving small keys; `full` decides if the keys are equal.
template <class Item, class Key, class Full>
void sort_by(std::vector<Item>& items, const Key& key, const Full& full) {
  std::vector<std::pair<decltype(key(items[0])), std::uint32_t>> keys;
  keys.reserve(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) keys.emplace_back(key(items[i]), i);
  std::sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    return full(items[a.second]) < full(items[b.second]);
  });
  std::vector<std::uint32_t> order(items.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& entry) { return entry.second; });
  permute(items, order);
}

template <class Item, class Same>
std::uint64_t merge_repeated(std::vector<Item>& items, const Same& same) {
  const auto end = std::unique(items.begin(), items.end(), same);
  const auto count = static_cast<std::uint64_t>(items.end() - end);
  items.erase(end, items.end());
  return count;
}

}  // namespace

void LogCollector::begin_file(const std::string& name, bool companion) {
  file_ = static_cast<std::uint32_t>(files_.size());
  files_.push_back(name);
  companion_ = companion;
  d3hsp_ = stdout_ = false;
  messages_.begin_file();
}

void LogCollector::end_file() {
  for (Contact& contact : contacts_) {
    if (d3hsp_ || stdout_)
      contact.in_copies = std::max(contact.in_copies, contact.in_file);
    else
      contact.in_message_files += contact.in_file;
    contact.in_file = 0;
    // Files of one run repeat each other; the one that says most counts.
    const std::optional<InitialSummary> said = std::exchange(contact.summary_in_file, std::nullopt);
    std::optional<InitialSummary>& known = contact.summary.initial_summary;
    if (said && (!known || said->nodes + said->eliminated > known->nodes + known->eliminated)) known = said;
  }
  // A negative limit applies to the files, any limit to the screen.
  const auto limit = static_cast<std::uint64_t>(message_limit_ < 0 ? -message_limit_ : message_limit_);
  if (message_limit_ < 0 && messages_.any_block_counted(limit)) run_.counts_may_be_cut = true;
  if (stdout_ && messages_.any_block_counted(limit == 0 ? default_message_limit : limit)) run_.counts_may_be_cut = true;
}

std::uint32_t LogCollector::slot(std::int64_t contact_id) {
  const auto [found, is_new] = slots_.try_emplace(contact_id, static_cast<std::uint32_t>(contacts_.size()));
  if (is_new) contacts_.emplace_back().summary.id = contact_id;
  return found->second;
}

void LogCollector::set_type(std::uint32_t slot, std::string_view type, TypeSource source) {
  Contact& contact = contacts_[slot];
  if (source < contact.type_source) return;
  std::string code(type);
  std::erase(code, ' ');
  if (code.empty()) return;
  contact.summary.type = std::move(code);
  contact.type_source = source;
}

void LogCollector::count_penetrations(std::uint32_t slot, std::uint64_t count) {
  if (companion_) return;
  contacts_[slot].in_file = std::max(contacts_[slot].in_file, count);
}

void LogCollector::add_summary(std::uint32_t slot, const InitialSummary& summary) {
  if (companion_) return;
  std::optional<InitialSummary>& sum = contacts_[slot].summary_in_file;
  if (!sum) sum.emplace();
  sum->add(summary);
  count_penetrations(slot, sum->nodes);
}

void LogCollector::add(const SurfaceTimestep& step) {
  bool& seen = step.side == 'A' ? contacts_[step.contact].timestep_a : contacts_[step.contact].timestep_b;
  if (!std::exchange(seen, true)) run_.surface_timesteps.push_back(step);
}

void LogCollector::count_bytes(std::uint64_t bytes, std::uint64_t lines) {
  bytes_ += bytes;
  lines_ += lines;
}

/// Deck order if known, then by id; only those of LogOptions::contacts. Renumbers references to slots.
void LogCollector::sort_contacts(const LogOptions& options) {
  std::vector<std::uint32_t> order(contacts_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](const ContactSummary& c) { return std::tuple(c.order == 0, c.order, c.id); };
    return key(contacts_[a].summary) < key(contacts_[b].summary);
  });
  std::vector<std::uint32_t> place(contacts_.size(), no_position);
  std::deque<Contact> sorted;
  for (const std::uint32_t at : order) {
    const auto& wanted = options.contacts;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), contacts_[at].summary.id) == wanted.end()) continue;
    place[at] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(std::move(contacts_[at]));
  }
  contacts_ = std::move(sorted);
  const auto renumber = [&](auto& records) {
    for (auto& record : records) record.contact = place[record.contact];
    std::erase_if(records, [](const auto& record) { return record.contact == no_position; });
  };
  renumber(penetrations_);
  renumber(tie_failures_);
  renumber(run_.surface_timesteps);
}

/// Both ranks judge a node on their border. If only one of them finds it on a segment, that one's reason counts.
void LogCollector::drop_not_found_elsewhere() {
  using NodeOfFile = std::tuple<std::uint32_t, std::int64_t, std::uint32_t>;
  std::vector<NodeOfFile> found;  // contact, node, file
  for (const TieFailure& t : tie_failures_)
    if (untied(t.reason) && t.reason != TieReason::not_found) found.emplace_back(t.contact, t.node, t.file);
  std::sort(found.begin(), found.end());
  repeated_ += std::erase_if(tie_failures_, [&](const TieFailure& t) {
    if (t.reason != TieReason::not_found) return false;
    auto other = std::lower_bound(found.begin(), found.end(), NodeOfFile(t.contact, t.node, 0));
    for (; other != found.end() && std::get<0>(*other) == t.contact && std::get<1>(*other) == t.node; ++other)
      if (std::get<2>(*other) != t.file) return true;
    return false;
  });
}

/// Sorts into the order promised by Report; the same record from several files becomes one.
void LogCollector::sort_records() {
  std::ranges::stable_sort(run_.surface_timesteps, {}, &SurfaceTimestep::contact);
  sort_by(
      penetrations_, [](const Penetration& p) { return std::tuple(p.contact, -p.depth, p.node); },
      [](const Penetration& p) { return std::tuple(p.segment_number, p.segment, p.kind, p.file, p.line); });
  repeated_ += merge_repeated(penetrations_, [](const Penetration& a, const Penetration& b) {
    return a.contact == b.contact && a.node == b.node && a.depth == b.depth && a.segment_number == b.segment_number &&
           a.segment == b.segment && a.kind == b.kind;
  });
  // Of records of the same node the most complete one comes first and stays.
  sort_by(
      tie_failures_, [](const TieFailure& t) { return std::tuple(t.contact, t.reason, t.node); },
      [](const TieFailure& t) { return std::tuple(t.segment_number == 0, t.distance < 0, t.file, t.line); });
  repeated_ += merge_repeated(tie_failures_, [](const TieFailure& a, const TieFailure& b) {
    return a.contact == b.contact && a.node == b.node && a.reason == b.reason;
  });
  drop_not_found_elsewhere();
  sort_by(
      run_.rigidwalls, [](const RigidwallPenetration& w) { return std::tuple(w.wall, w.node, w.depth); },
      [](const RigidwallPenetration& w) { return std::tuple(w.file, w.line); });
  repeated_ += merge_repeated(run_.rigidwalls, [](const RigidwallPenetration& a, const RigidwallPenetration& b) {
    return a.wall == b.wall && a.node == b.node && a.depth == b.depth;
  });
}

void LogCollector::count_records(Report& report) const {
  for (const Penetration& record : report.penetrations) {
    count(record, report.contacts[record.contact]);
  }
  for (const TieFailure& failure : report.tie_failures)
    if (untied(failure.reason)) ++report.contacts[failure.contact].untied;
}

Report LogCollector::finish(const LogOptions& options) {
  sort_contacts(options);
  sort_records();
  Report report;
  report.source = "messag";
  report.files = std::move(files_);
  for (Contact& contact : contacts_) {
    contact.summary.reported_penetrations = std::max(contact.in_message_files, contact.in_copies);
    report.contacts.push_back(std::move(contact.summary));
  }
  report.model.contacts = report.contacts.size();
  report.penetrations = std::move(penetrations_);
  report.tie_failures = std::move(tie_failures_);
  count_records(report);
  run_.messages = messages_.take();
  report.run = std::move(run_);
  report.statistics = {{"bytes read", fmt::format("{}", bytes_)},
                       {"lines read", fmt::format("{}", lines_)},
                       {"penetration records", fmt::format("{}", report.penetrations.size())},
                       {"tie records", fmt::format("{}", report.tie_failures.size())},
                       {"records that repeat another", fmt::format("{}", repeated_)}};
  return report;
}

}  // namespace gapcheck::results
