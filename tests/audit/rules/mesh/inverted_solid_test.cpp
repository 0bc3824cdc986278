#include <map>

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

TEST(InvertedSolid, ManyAreCountedByWhatIsWrong) {
  // Bricks 1 … 12 with the corner of OneCorner, and 21 … 33 turned inside out.
  RuleDeck deck;
  deck.shell_part(9, 1).raw("SECTION_SOLID", "1,1\n").raw("PART", "bricks\n1,1,1\n");
  for (int i = 0; i < 33; ++i) {
    if (i >= 12 && i < 20) continue;
    const std::int64_t n = 100 + 8 * i;
    const Vector at(5 * i, 0, 0);
    const double seven = i < 12 ? 0.2 : 1;
    const Vector corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {seven, seven, seven},
                              {0, 1, 1}};
    for (int k = 0; k < 8; ++k) deck.node(n + k, at + corners[k]);
    if (i < 12)
      deck.solid(i + 1, 1, {n, n + 1, n + 2, n + 3, n + 4, n + 5, n + 6, n + 7});
    else
      deck.solid(i + 1, 1, {n + 4, n + 5, n + 6, n + 7, n, n + 1, n + 2, n + 3});
  }
  const Report report = run_rule("GC510", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
  ASSERT_EQ(listed(report), 22U);
  std::map<Severity, std::string> rest;
  for (const Finding& f : report.findings)
    if (f.count > 1) rest[f.severity] = fmt::format("{}: {}", f.count, f.message);
  EXPECT_EQ(rest[Severity::error], "3: 3 more solids of part 1 are turned inside out");
  EXPECT_EQ(rest[Severity::warning], "2: 2 more solids of part 1 are turned inside out at a corner");
}

TEST(InvertedSolid, TetrahedraAndWedges) {
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 2, 3, 6, 6, 6, 6, 6}))), 0U);
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 3, 2, 6, 6, 6, 6, 6}))), 1U);
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 2, 6, 5, 4, 4, 8, 8}))), 1U);  // 1 2 6 5 looks away from 4 and 8
  EXPECT_EQ(listed(run_rule("GC510", brick(1, {1, 5, 6, 2, 4, 4, 8, 8}))), 0U);
}

TEST(InvertedSolid, CohesiveElementsHaveNoVolume) {
  const std::array<std::int64_t, 8> flat{1, 2, 3, 4, 1, 2, 3, 4};
  EXPECT_EQ(listed(run_rule("GC510", brick(1, flat, 19))), 0U);
  // The same with nodes of its own on either side.
  const auto found = [](int elform) {
    RuleDeck deck;
    for (int i = 0; i < 8; ++i) deck.node(1 + i, Vector(i % 4 == 1 || i % 4 == 2 ? 1 : 0, i % 4 > 1 ? 1 : 0, 0));
    deck.raw("SECTION_SOLID", fmt::format("1,{}\n", elform)).raw("PART", "glue\n1,1,1\n");
    deck.solid(9, 1, {1, 2, 3, 4, 5, 6, 7, 8});
    return listed(run_rule("GC510", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
  };
  for (const int cohesive : {19, 20, 21, 22}) EXPECT_EQ(found(cohesive), 0U) << cohesive;
  for (const int other : {1, 2, 18, 23}) EXPECT_EQ(found(other), 1U) << other;
}

}  // namespace
}  // namespace gapcheck::audit_test::inverted_solid_test
