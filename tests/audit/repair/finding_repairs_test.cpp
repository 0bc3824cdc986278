// Which repairs are for which findings, of decks that are audited as usual.
#include "audit/repair/finding_repairs.hpp"

#include <map>
#include <set>
#include <string>

#include "audit/fix/plates.hpp"
#include "audit/repair/run_repairs.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit_test::finding_repairs_test {
namespace {

/// By the id of a rule the repairs of its findings; "-" where a finding has none.
using Listed = std::map<std::string, std::set<std::string>>;

std::string rule_id(const Report& report, std::size_t number) {
  std::size_t at = number - 1;
  if (at < report.penetrations.size()) return std::string(rule_of(report.penetrations[at].kind).id);
  at -= report.penetrations.size();
  if (at < report.tie_failures.size()) return std::string(rule_of(report.tie_failures[at]).id);
  return report.findings.at(at - report.tie_failures.size()).id;
}

std::size_t findings(const Report& report) {
  return report.penetrations.size() + report.tie_failures.size() + report.findings.size();
}

Listed listed(const Report& report, const RepairPlan& plan) {
  Listed list;
  for (std::size_t number = 1; number <= findings(report); ++number) {
    std::set<std::string>& ids = list[rule_id(report, number)];
    const auto target = audit::repair_target(report, number);
    if (!target) ids.insert("-");
    if (target)
      for (const Repair* repair : audit::repairs_for(plan, *target)) ids.insert(repair->id);
  }
  return list;
}

TEST(FindingRepairs, PenetrationsAndTheirFreeThickness) {
  const std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}, Plate{.id = 9, .x = 100});
  audit::AuditOptions options;
  options.select = {"GC101", "GC308", "GC421"};
  const AuditRun audited = run_text(text, options);
  const Listed list = listed(audited.report, RepairRun(text).listed());
  EXPECT_EQ(list.at("GC101"),
            (std::set<std::string>{"1-exclude", "1-ignore", "1-optt", "1-sections", "1-sst", "1-tie"}));
  EXPECT_EQ(list.at("GC308"), (std::set<std::string>{"1-optt", "1-sections", "1-sst"}));
  EXPECT_EQ(list.at("GC421"), std::set<std::string>{"-"});
  EXPECT_FALSE(audit::repair_target(audited.report, 0));
  EXPECT_FALSE(audit::repair_target(audited.report, findings(audited.report) + 1));
}

TEST(FindingRepairs, TiesThatAreTooShort) {
  const std::string tie =
      "*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET_ID\n         3\n         2         1         3         3\n\n"
      "        1.        1.        0.        0.\n";
  const std::string text =
      "*KEYWORD\n" + elastic_steel + Plate{.id = 1}.deck() + Plate{.id = 2, .z = 1.5}.deck() + tie + "*END\n";
  audit::AuditOptions options;
  options.select = {"GC201", "GC208"};
  const Listed list = listed(run_text(text, options).report, RepairRun(text).listed());
  EXPECT_EQ(list, (Listed{{"GC201", {"1-reach"}}, {"GC208", {"1-reach"}}}));
}

// Each pair of parts has its own repairs, and a fix comes once for each rule, with its first finding.
TEST(FindingRepairs, EachPairHasItsOwn) {
  const std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}, Plate{.id = 3, .z = 1.6});
  audit::AuditOptions options;
  options.select = {"GC101", "GC308"};
  const AuditRun audited = run_text(text, options);
  RepairRun run(text);
  const RepairPlan plan = run.plan({}, audit::Tried::cards);
  ASSERT_EQ(plan.pairs.size(), 2u);
  for (std::size_t number = 1; number <= audited.report.penetrations.size(); ++number) {
    const Penetration& record = audited.report.penetrations[number - 1];
    const std::string prefix = record.part + record.element_part == 3 ? "1-" : "2-";
    const auto target = audit::repair_target(audited.report, number);
    ASSERT_TRUE(target);
    const auto repairs = audit::repairs_for(plan, *target);
    EXPECT_FALSE(repairs.empty());
    for (const Repair* repair : repairs) EXPECT_TRUE(repair->id.starts_with(prefix)) << repair->id;
  }
  const audit::FindingRepairs fixes = audit::solving_repairs(plan, audited.report);
  std::multiset<std::string> with;
  for (const auto& [number, repairs] : fixes) {
    with.insert(rule_id(audited.report, number));
    for (const Repair* repair : repairs) EXPECT_TRUE(repair->outcome.solves()) << repair->id;
  }
  EXPECT_EQ(with.count("GC101"), 2u);
  EXPECT_EQ(with.count("GC308"), 1u);
  // What was not tried solves nothing.
  EXPECT_TRUE(audit::solving_repairs(run.listed(), audited.report).empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::finding_repairs_test
