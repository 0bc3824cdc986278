#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_by_part_test {
namespace {

/// A plate (part 1) and one that stands on it (part 2) with rows of three nodes at z = 0, `second` and 30. Ties up to
/// 0.6 (1 + 1) = 1.2; nodes within 2.4 are judged.
RuleDeck standing_plate(double second, const std::string& card1) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  const double z[] = {0, second, 30};
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 3; ++i) deck.node(51 + 10 * row + i, Vector(3 + 6 * i, 5, z[row]));
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 2; ++i) {
      const std::int64_t n = 51 + 10 * row + i;
      deck.shell(n, 2, {n, n + 1, n + 11, n + 10});
    }
  deck.raw("SET_NODE_LIST", "7\n51,52,53,61\n").raw("SET_PART_LIST", "8\n2\n").raw("SET_PART_TREE", "9\n\n-2\n");
  return deck.contact(1, "TIED_SHELL_EDGE_TO_SURFACE", card1);
}

TEST(TieByPart, NodesNearByStayUntied) {
  for (const char* card1 : {"2,1,3,3", "8,1,2,3", "9,1,7,3"}) {
    const Report report = run_rule("GC209", standing_plate(2, card1));
    ASSERT_EQ(listed(report), 1U);
    EXPECT_EQ(report.findings[0].count, 3U);
    EXPECT_NE(report.findings[0].message.find("of 6 nodes near"), std::string::npos) << report.findings[0].message;
    EXPECT_EQ(report.contacts[0].out_of_reach, 3U);
    EXPECT_EQ(listed(run_rule("GC209", standing_plate(2.5, card1))), 0U);
  }
}

TEST(TieByPart, NotForNodeSets) { EXPECT_EQ(listed(run_rule("GC209", standing_plate(2, "7,1,4,3"))), 0U); }

}  // namespace
}  // namespace gapcheck::audit_test::tie_by_part_test
