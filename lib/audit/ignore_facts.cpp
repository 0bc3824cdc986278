#include "audit/ignore_facts.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "audit/audit.hpp"
#include "audit/registry.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit {

std::vector<Fact> facts_of(const Report& report) {
  std::unordered_map<std::string_view, std::uint32_t> position_of;
  for (std::uint32_t i = 0; i < rules().size(); ++i) position_of.emplace(rules()[i].id, i);
  const auto rule = [&](std::string_view id) {
    const auto found = position_of.find(id);
    return found == position_of.end() || rules()[found->second].of_ignores() ? no_position : found->second;
  };
  const auto file = [&](std::uint32_t position, std::uint32_t line) {
    return line != 0 && position < report.files.size() ? &report.files[position] : nullptr;
  };
  std::array<std::uint32_t, penetration_kinds> rule_of_kind{};
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind)
    rule_of_kind[kind] = rule(rule_of(static_cast<PenetrationKind>(kind)).id);
  std::vector<Fact> facts;
  facts.reserve(report.penetrations.size() + report.tie_failures.size() + report.findings.size());
  for (const Penetration& p : report.penetrations)
    facts.push_back({rule_of_kind[static_cast<std::size_t>(p.kind)], no_position, report.contacts[p.contact].id, p.node,
                     p.part, p.element_part, p.element, p.depth, p.contact_distance, file(p.file, p.line)});
  for (const TieFailure& t : report.tie_failures)
    facts.push_back({rule(rule_of(t.reason).id), no_position, report.contacts[t.contact].id, t.node, t.part, 0, 0, -1,
                     -1, file(t.file, t.line)});
  for (const Finding& f : report.findings)
    facts.push_back({rule(f.id), no_position, f.contact, f.node, f.part, f.element_part, f.element, f.penetration,
                     f.contact_distance, f.file.empty() ? nullptr : &f.file});
  return facts;
}

void join(std::vector<IdRange>& ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const IdRange& a, const IdRange& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (const IdRange& range : ranges) {
    if (kept > 0 && range.first <= ranges[kept - 1].last)
      ranges[kept - 1].last = std::max(ranges[kept - 1].last, range.last);
    else
      ranges[kept++] = range;
  }
  ranges.resize(kept);
}

bool holds(const std::vector<IdRange>& ranges, std::int64_t id) {
  const auto behind = std::upper_bound(ranges.begin(), ranges.end(), id,
                                       [](std::int64_t value, const IdRange& range) { return value < range.first; });
  return id != 0 && behind != ranges.begin() && id <= std::prev(behind)->last;
}

void FactIndex::finish() {
  std::sort(entries_.begin(), entries_.end());
  for (const Entry& entry : entries_)
    if (rules_.empty() || rules_.back() != entry.rule) rules_.push_back(entry.rule);
  next_.resize(entries_.size() + 1);
  std::iota(next_.begin(), next_.end(), std::size_t{0});
}

std::size_t FactIndex::count(const std::vector<bool>& rules, const std::vector<IdRange>& ranges) const {
  std::size_t sum = 0;
  for_each_run(rules, ranges, [&](std::size_t first, std::size_t end) { return sum += end - first, true; });
  return sum;
}

std::size_t FactIndex::first_from(const Entry& entry) const {
  return static_cast<std::size_t>(std::lower_bound(entries_.begin(), entries_.end(), entry) - entries_.begin());
}

std::size_t FactIndex::first_behind(const Entry& entry) const {
  return static_cast<std::size_t>(std::upper_bound(entries_.begin(), entries_.end(), entry) - entries_.begin());
}

/// Entries with a source point to the next entry; paths are halved on the way.
std::size_t FactIndex::next_free(std::size_t at) {
  for (;;) {
    if (next_[at] == at) {
      if (at == entries_.size() || facts_[entries_[at].fact].source == no_position) return at;
      next_[at] = at + 1;
    }
    next_[at] = next_[next_[at]];
    at = next_[at];
  }
}

}  // namespace gapcheck::audit
