#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::warped_segment_test {
namespace {

/// A square of 10 with its third corner raised, in contacts 1 and 2.
RuleDeck raised(double height) {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, {0, 0, 0}).node(2, {10, 0, 0}).node(3, {10, 10, height}).node(4, {0, 10, 0});
  deck.shell(7, 1, {1, 2, 3, 4});
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0").contact(2, "AUTOMATIC_SINGLE_SURFACE", "0");
  return deck;
}

// cos a = 1 / (1 + (h / 10)²): 30.5 degrees at 4, 19.9 at 2.519, 20.1 at 2.546.
TEST(WarpedSegment, BeyondTwentyDegreesOnly) {
  const Report report = run_rule("GC504", raised(4));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].element, 7);
  EXPECT_EQ(report.findings[0].element_part, 1);
  EXPECT_EQ(report.findings[0].contact, 1);
  EXPECT_NE(report.findings[0].message.find("shell 7 of part 1 is warped by 30.5 degrees"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC504", raised(2.546))), 1U);
  EXPECT_EQ(listed(run_rule("GC504", raised(2.519))), 0U);
}

TEST(WarpedSegment, OfChosenPartsAndContactsOnly) {
  audit::AuditOptions options;
  options.parts = {2};
  EXPECT_EQ(listed(run_rule("GC504", raised(4), options)), 0U);
  options.parts = {1};
  options.contacts = {2};
  const Report report = run_rule("GC504", raised(4), options);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 2);
}

TEST(WarpedSegment, TenInFullAndTheRestCounted) {
  RuleDeck deck;
  deck.shell_part(1, 1);
  for (int i = 0; i < 13; ++i) {
    const std::int64_t n = 10 * (i + 1);
    deck.node(n, {0, 0, 9.0 * i})
        .node(n + 1, {10, 0, 9.0 * i})
        .node(n + 2, {10, 10, 9.0 * i + 4})
        .node(n + 3, {0, 10, 9.0 * i});
    deck.shell(n, 1, {n, n + 1, n + 2, n + 3});
  }
  const Report report = run_rule("GC504", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
  ASSERT_EQ(listed(report), 11U);
  std::uint64_t all = 0;
  for (const Finding& f : report.findings) all += f.count;
  EXPECT_EQ(all, 13U);
}

TEST(WarpedSegment, NeedsAContact) {
  RuleDeck deck;
  deck.shell_part(1, 1)
      .node(1, {0, 0, 0})
      .node(2, {10, 0, 0})
      .node(3, {10, 10, 4})
      .node(4, {0, 10, 0})
      .shell(7, 1, {1, 2, 3, 4});
  const Report report = run_rule("GC504", deck);
  EXPECT_EQ(listed(report), 0U);
  EXPECT_NE(std::find(report.statistics.begin(), report.statistics.end(),
                      std::pair<std::string, std::string>("not looked at", "GC504: no contact has any segments")),
            report.statistics.end());
}

TEST(WarpedSegment, NotFabric) {
  const auto deck = [](const std::string& material) {
    return "*KEYWORD\n*PART\nbag\n1,1,3\n*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n" + material +
           "*NODE\n1,0.,0.,0.\n2,10.,0.,0.\n3,10.,10.,4.\n4,0.,10.,0.\n*ELEMENT_SHELL\n7,1,1,2,3,4\n"
           "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.\n1.,1.\n*END\n";
  };
  EXPECT_EQ(listed(run_rule("GC504", deck("*MAT_ELASTIC\n3,1e-9,300.,0.3\n"))), 1U);
  EXPECT_EQ(listed(run_rule("GC504", deck("*MAT_FABRIC\n3,1e-9,300.,300.,,0.3,0.3\n100.\n\n\n\n"))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::warped_segment_test
