#include "audit/ignore_reviews.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "audit/ignore_demand.hpp"

namespace gapcheck::audit {
namespace {

/// The position in `sources` of an entry, which is added if missing.
std::uint32_t source_of(const IgnoreEntry& entry, std::vector<IgnoreSource>& sources) {
  const auto same = [&](const IgnoreSource& s) {
    return !s.in_deck && s.line == entry.line && s.file == entry.file && s.reason == entry.reason;
  };
  const auto found = std::find_if(sources.begin(), sources.end(), same);
  if (found != sources.end()) return static_cast<std::uint32_t>(found - sources.begin());
  sources.push_back({entry.file, entry.line, entry.reason, false, 0});
  return static_cast<std::uint32_t>(sources.size() - 1);
}

}  // namespace

void leave_out_reviews(Report& report, std::size_t first, const AuditOptions& options) {
  if (report.findings.size() == first) return;
  RuleLists lists;
  std::vector<Demand> demands;
  for (const IgnoreEntry& entry : options.ignores)
    if (!expired(entry, options)) demands.emplace_back(entry, lists);
  const auto leaves_out = [&](const Finding& f) -> const IgnoreEntry* {
    const auto of_entry = [&](const IgnoreEntry& entry) { return entry.file == f.file; };
    const RuleIdentity* rule = find_rule(f.id);
    if (rule == nullptr || std::any_of(options.ignores.begin(), options.ignores.end(), of_entry)) return nullptr;
    Fact fact;
    fact.rule = static_cast<std::uint32_t>(rule - rules().data());
    fact.file = &f.file;
    const auto demand = std::find_if(demands.begin(), demands.end(), [&](Demand& d) { return d.matches(fact); });
    return demand == demands.end() ? nullptr : &demand->entry();
  };
  std::size_t kept = first;
  for (std::size_t i = first; i < report.findings.size(); ++i) {
    Finding& f = report.findings[i];
    if (const IgnoreEntry* entry = leaves_out(f)) {
      const std::uint32_t source = source_of(*entry, report.ignored.sources);
      ++report.ignored.sources[source].matched;
      report.ignored.source.push_back(source);
      report.ignored.findings.push_back(std::move(f));
    } else if (kept++ != i) {
      report.findings[kept - 1] = std::move(f);
    }
  }
  report.findings.resize(kept);
}

}  // namespace gapcheck::audit
