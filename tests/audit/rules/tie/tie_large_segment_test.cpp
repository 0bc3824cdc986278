#include <set>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_large_segment_test {
namespace {

/// n x n bricks of edge `edge`, `gap` above a brick of 20, whose upper face has D = 28.28 and ties up to 1.414.
Report bricks(int n, double edge, double gap, const std::string& cards = "0.\n1.,1.\n") {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, -20), Vector(20, 20, 20));
  deck.block(101, 2, n, n, 1, Vector(5, 5, gap), Vector(edge, edge, edge));
  return run_rule("GC207", deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3", cards));
}

TEST(TieLargeSegment, SmallElementsOverALargeSegment) {
  const Report report = bricks(1, 1, 0.8);
  ASSERT_EQ(listed(report), 4U);
  std::set<std::int64_t> nodes;
  for (const Finding& finding : report.findings) {
    nodes.insert(finding.node);
    EXPECT_EQ(finding.part, 2);
    EXPECT_EQ(finding.element_part, 1);
    EXPECT_EQ(finding.contact, 1);
    EXPECT_NE(finding.message.find("ties over 0.8 "), std::string::npos) << finding.message;
    EXPECT_NE(finding.message.find("edges of 1;"), std::string::npos) << finding.message;
  }
  EXPECT_EQ(nodes, (std::set<std::int64_t>{101, 102, 103, 104}));
}

TEST(TieLargeSegment, NotWhereOneOfTheThreeIsMissing) {
  EXPECT_EQ(listed(bricks(1, 2.9, 0.8)), 0U);                   // 28.3 < 10 * 2.9
  EXPECT_EQ(listed(bricks(1, 2.8, 0.28)), 0U);                  // less than 0.01 D
  EXPECT_EQ(listed(bricks(1, 1, 0.28)), 4U);                    // but the upper nodes, 1.28 away, tie as well
  EXPECT_EQ(listed(bricks(1, 1, 1.5)), 0U);                     // does not tie
  EXPECT_EQ(listed(bricks(1, 1, 0.8, "0.\n1.,1.,-2.\n")), 0U);  // thickness alone counts
  EXPECT_EQ(listed(bricks(1, 2.8, 0.8)), 4U);
}

TEST(TieLargeSegment, ManyAreCounted) {
  const Report report = bricks(4, 1, 0.8);  // 25 lower nodes
  ASSERT_EQ(listed(report), 11U);
  std::uint64_t total = 0;
  for (const Finding& finding : report.findings) total += finding.count;
  EXPECT_EQ(total, 25U);
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_large_segment_test
