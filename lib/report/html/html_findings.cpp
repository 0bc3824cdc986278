#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "report/export/exports_groups.hpp"
#include "report/html/html_data.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"

namespace gapcheck::report {
namespace {

/// One finding by position: penetrations, ties, the others; then the same for those left out on purpose.
struct Candidate {
  bool among_first = false;  ///< of its rule and contact
  Severity severity = Severity::note;
  double depth = 0;
  std::size_t place = 0;
  bool ignored = false;
  [[nodiscard]] auto key() const {
    return std::tuple(!among_first, ignored, -static_cast<int>(severity), -depth, place);
  }
};

std::vector<Candidate> candidates(const Report& report, std::size_t group) {
  std::vector<Candidate> list;
  list.reserve(report.penetrations.size() + report.tie_failures.size() + report.findings.size() +
               report.ignored.size());
  const auto add_all = [&](const auto& lists, bool ignored) {
    std::map<std::pair<std::int64_t, std::string_view>, std::size_t> found;
    const auto add = [&](std::int64_t contact, std::string_view rule, Severity severity, double depth) {
      const bool first = found[{contact, rule}]++ < group;
      list.push_back({first, severity, std::isfinite(depth) ? depth : 0, list.size(), ignored});
    };
    for (const Penetration& record : lists.penetrations) {
      const RuleIdentity rule = rule_of(report, record);
      add(record.contact, rule.id, rule.severity, record.depth);
    }
    for (const TieFailure& failure : lists.tie_failures) {
      const RuleIdentity rule = rule_of(report, failure);
      add(failure.contact, rule.id, rule.severity, 0);
    }
    for (const Finding& finding : lists.findings)
      add(finding.contact, finding.id, finding.severity, finding.penetration);
  };
  add_all(report, false);
  add_all(report.ignored, true);
  return list;
}

HtmlFinding make(const Report& report, const Penetration& record, const NodePosition& position) {
  HtmlFinding finding{item_of(report, record), {}, 0, node_of(report, record, position), std::nullopt};
  if (std::any_of(record.segment.begin(), record.segment.end(), [](std::int64_t node) { return node != 0; }))
    finding.segment.assign(record.segment.begin(), record.segment.end());
  if (const auto line = penetration_line(report, record, position)) finding.vector = line->surface - line->node;
  return finding;
}

/// The finding with this number of the three lists.
template <class Lists>
HtmlFinding made_from(const Report& report, const Lists& lists, std::size_t number, const NodePosition& position) {
  const auto node_position = [&](std::int64_t node) { return position && node != 0 ? position(node) : std::nullopt; };
  const std::size_t ties = lists.penetrations.size(), others = ties + lists.tie_failures.size();
  if (number < ties) return make(report, lists.penetrations[number], position);
  if (number < others) {
    const TieFailure& failure = lists.tie_failures[number - ties];
    return {item_of(report, failure), {}, 0, node_position(failure.node), std::nullopt};
  }
  const Finding& finding = lists.findings[number - others];
  return {item_of(finding), {}, 0, finding.point ? finding.point : node_position(finding.node), std::nullopt};
}

}  // namespace

std::vector<HtmlFinding> html_findings(const Report& report, const NodePosition& position, const HtmlOptions& options) {
  std::vector<Candidate> chosen = candidates(report, options.group);
  const auto by_key = [](const Candidate& a, const Candidate& b) { return a.key() < b.key(); };
  if (chosen.size() > options.findings) {
    const auto end = chosen.begin() + static_cast<std::ptrdiff_t>(options.findings);
    std::nth_element(chosen.begin(), end, chosen.end(), by_key);
    chosen.erase(end, chosen.end());
  }
  std::sort(chosen.begin(), chosen.end(), [](const Candidate& a, const Candidate& b) { return a.place < b.place; });
  const std::size_t found = report.penetrations.size() + report.tie_failures.size() + report.findings.size();
  std::vector<HtmlFinding> list;
  list.reserve(chosen.size());
  for (const Candidate& candidate : chosen) {
    if (!candidate.ignored) {
      list.push_back(made_from(report, report, candidate.place, position));
      list.back().item.state = state_of(report, candidate.place);
    } else {
      const std::size_t number = candidate.place - found;
      list.push_back(made_from(report, report.ignored, number, position));
      list.back().item.ignored = &report.ignored.sources[report.ignored.source[number]];
    }
    list.back().number = candidate.place + 1;
  }
  return list;
}

}  // namespace gapcheck::report
