#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::inverted_solid_test {
namespace {

/// A brick 1 … 8 of edge 1 with node 7 at a point on its diagonal, its nodes in this order.
RuleDeck brick(double seven, const std::array<std::int64_t, 8>& order = {1, 2, 3, 4, 5, 6, 7, 8}, int elform = 1) {
  RuleDeck deck;
  deck.node(1, {0, 0, 0}).node(2, {1, 0, 0}).node(3, {1, 1, 0}).node(4, {0, 1, 0});
  deck.node(5, {0, 0, 1}).node(6, {1, 0, 1}).node(7, {seven, seven, seven}).node(8, {0, 1, 1}).solid(9, 1, order);
  deck.raw("SECTION_SOLID", fmt::format("1,{}\n", elform)).raw("PART", "brick\n1,1,1\n");
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0");
}

TEST(InvertedSolid, WholeElement) {
  const Report report = run_rule("GC510", brick(1, {5, 6, 7, 8, 1, 2, 3, 4}));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::error);
  EXPECT_EQ(report.findings[0].element, 9);
  EXPECT_NE(
      report.findings[0].message.find("solid 9 of part 1 is turned inside out or has no volume (scaled Jacobian -1 in"),
      std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC510", brick(1))), 0U);
}

// At node 7: -1.4 / 1.32^1.5 = -0.923; in the middle 25.6 / 11.52^1.5 = 0.655.
TEST(InvertedSolid, OneCorner) {
  const Report report = run_rule("GC510", brick(0.2));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_EQ(report.findings[0].node, 7);
  EXPECT_NE(report.findings[0].message.find("(scaled Jacobian -0.923, 0.655 in its middle)"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC510", brick(0.7))), 0U);
}

TEST(InvertedSolid, TetrahedraAndWedges) {
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 2, 3, 6, 6, 6, 6, 6}))), 0U);
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 3, 2, 6, 6, 6, 6, 6}))), 1U);
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 2, 6, 5, 4, 4, 8, 8}))), listed(run_rule("GC510", brick(1))) + 1);
}

TEST(InvertedSolid, CohesiveElementsHaveNoVolume) {
  const std::array<std::int64_t, 8> flat{1, 2, 3, 4, 1, 2, 3, 4};
  EXPECT_EQ(listed(run_rule("GC510", brick(1, flat, 19))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::inverted_solid_test
