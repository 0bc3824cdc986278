#include "report/baseline/rule_counts.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/item.hpp"

namespace gapcheck::report {
namespace {

class RuleCounter {
 public:
  void add(const Report& report) {
    std::size_t number = 0;
    for (const Penetration& record : report.penetrations) add(report, rule_of(report, record), number++);
    for (const TieFailure& failure : report.tie_failures) add(report, rule_of(report, failure), number++);
    for (const Finding& finding : report.findings) add(report, finding, number++);
    if (report.baseline)
      for (const KnownFinding& known : report.baseline->gone) ++entry(known).baseline.gone;
  }

  [[nodiscard]] std::vector<RuleCount> sorted() const {
    std::vector<RuleCount> all;
    for (const auto& [id, counted] : rules_) all.push_back(counted.count);
    const auto key = [](const RuleCount& rule) {
      return std::tuple(-static_cast<int>(rule.severity), -static_cast<std::ptrdiff_t>(rule.decks), rule.id);
    };
    std::ranges::sort(all, {}, key);
    return all;
  }

 private:
  struct Counted {
    RuleCount count;
    const Report* last = nullptr;  ///< deck that was counted
  };

  /// `what`: a rule or a finding of it.
  RuleCount& entry(const auto& what) { return counted(what).count; }
  Counted& counted(const auto& what) {
    Counted& counted = rules_[what.id];
    if (counted.count.id.empty()) {
      counted.count.id = what.id;
      if constexpr (requires { what.rule; })
        counted.count.rule = what.rule;
      else
        counted.count.rule = what.name;
    }
    return counted;
  }

  void add(const Report& report, const auto& what, std::size_t number) {
    Counted& rule = counted(what);
    if (rule.last != &report) ++rule.count.decks;
    rule.last = &report;
    ++rule.count.findings;
    rule.count.severity = std::max(rule.count.severity, what.severity);
    const auto state = state_of(report, number);
    if (state == BaselineState::fresh) ++rule.count.baseline.fresh;
    if (state == BaselineState::worse) ++rule.count.baseline.worse;
    if (state == BaselineState::unchanged) ++rule.count.baseline.unchanged;
  }

  std::map<std::string_view, Counted> rules_;  ///< by id
};

}  // namespace

std::vector<RuleCount> rule_counts(std::span<const Report> reports) {
  RuleCounter counter;
  for (const Report& report : reports) counter.add(report);
  return counter.sorted();
}

}  // namespace gapcheck::report
