#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::coincident_surfaces_test {
namespace {

/// Four shells of part 1 with nodes 1 to 9, and another shell on four nodes.
RuleDeck plate_and(const std::vector<std::int64_t>& nodes) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.node(20, Vector(0, 0, 0)).shell(50, 2, nodes);
  return deck;
}

TEST(CoincidentSurfaces, TheSameNodesInAnyOrder) {
  for (const auto& nodes : std::vector<std::vector<std::int64_t>>{{1, 2, 5, 4}, {5, 4, 1, 2}, {4, 5, 2, 1}}) {
    const RuleDeck deck = plate_and(nodes);
    const Report report = run_rule("GC111", deck);
    ASSERT_EQ(listed(report), 1U);
    const Finding& f = report.findings[0];
    EXPECT_EQ(f.element, 50);
    EXPECT_EQ(f.element_part, 2);
    EXPECT_EQ(f.part, 1);
    EXPECT_EQ(f.line, line_of(deck, fmt::format("50,2,{}", fmt::join(nodes, ","))));
    EXPECT_NE(f.message.find("shell 1 (part 1)"), std::string::npos) << f.message;
  }
}

TEST(CoincidentSurfaces, OneOtherNodeIsEnough) {
  EXPECT_EQ(listed(run_rule("GC111", plate_and({20, 2, 5, 4}))), 0U) << "at the same place, but another node";
  EXPECT_EQ(listed(run_rule("GC111", plate_and({1, 2, 5}))), 0U) << "half of the quad";
}

TEST(CoincidentSurfaces, Triangles) {
  RuleDeck deck = plate_and({1, 2, 5});
  deck.shell(51, 1, {5, 1, 2});
  EXPECT_EQ(listed(run_rule("GC111", deck)), 1U);
}

TEST(CoincidentSurfaces, NullShellsAreCoats) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 3).raw("MAT_NULL", "3,7.85e-9\n").plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.shell(50, 2, {1, 2, 5, 4});
  EXPECT_EQ(listed(run_rule("GC111", deck)), 0U);
}

TEST(CoincidentSurfaces, AWholePlateTwiceIsTenAndARest) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 4, 4, Vector(0, 0, 0), 5, 5);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const std::int64_t n = 1 + 5 * j + i;
      deck.shell(100 + 4 * j + i, 2, {n, n + 1, n + 6, n + 5});
    }
  const Report report = run_rule("GC111", deck);
  ASSERT_EQ(listed(report), 11U);
  EXPECT_EQ(report.findings.back().count, 6U);
  audit::AuditOptions options;
  options.parts = {3};
  EXPECT_EQ(listed(run_rule("GC111", deck, options)), 0U);
}

TEST(CoincidentSurfaces, SegmentSetsThatNameASegmentTwice) {
  const auto deck = [](const std::string& segments) {
    RuleDeck d = plate_and({20, 2, 5, 4});
    d.raw("SET_SEGMENT", "7\n" + segments);
    return d.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "7,2,0,3")
        .contact(4, "AUTOMATIC_SURFACE_TO_SURFACE", "7,1,0,3");
  };
  EXPECT_EQ(listed(run_rule("GC111", deck("1,2,5,4\n2,3,6,5\n"))), 0U);
  const Report report = run_rule("GC111", deck("1,2,5,4\n2,3,6,5\n5,4,1,2\n4,5,2,1\n"));
  ASSERT_EQ(listed(report), 1U) << "once for the set, not for each contact";
  EXPECT_EQ(report.findings[0].contact, 3);
  EXPECT_EQ(report.findings[0].count, 2U);
}

}  // namespace
}  // namespace gapcheck::audit_test::coincident_surfaces_test
