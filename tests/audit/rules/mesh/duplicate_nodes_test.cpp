#include <algorithm>
#include <map>
#include <utility>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::duplicate_nodes_test {
namespace {

/// Two plates of 2 x 4 shells of 5 x 5 that meet at x = 10: nodes 3, 6, … 15 of part 1 and 101, 104, … 113 of the other
/// part. `gap` lies between them.
RuleDeck halves(std::int64_t other_part, double gap = 0) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 4, Vector(0, 0, 0), 5, 5);
  deck.plate(101, other_part, 2, 4, Vector(10 + gap, 0, 0), 5, 5);
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0");
}

TEST(DuplicateNodes, ASeamWithinAPart) {
  const Report report = run_rule("GC507", halves(1));
  ASSERT_EQ(listed(report), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(report.findings[i].node, 101 + 3 * static_cast<std::int64_t>(i));
  EXPECT_NE(report.findings[0].message.find("nodes 3 and 101 of part 1 are at the same place"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC507", halves(2))), 5U);
}

// Which nodes *NODE_MERGE joins is not read, so nobody can say that nothing joins these.
TEST(DuplicateNodes, NotWhereTheSolverMergesNodes) {
  RuleDeck deck = halves(1);
  const Report report = run_rule("GC507", deck.raw("SET_NODE_LIST_GENERATE", "3\n1,999\n")
                                              .raw("NODE_MERGE_SET", "3\n")
                                              .raw("NODE_MERGE_TOLERANCE", "0.05\n"));
  EXPECT_EQ(listed(report), 0U);
  EXPECT_NE(std::find(report.statistics.begin(), report.statistics.end(),
                      std::pair<std::string, std::string>(
                          "not looked at",
                          "GC507: the deck has *NODE_MERGE, which joins nodes at one place and is not read")),
            report.statistics.end());
}

// A thousandth of the shortest edge is 0.005.
TEST(DuplicateNodes, WithinTheToleranceOnly) {
  EXPECT_EQ(listed(run_rule("GC507", halves(1, 0.004))), 5U);
  EXPECT_EQ(listed(run_rule("GC507", halves(1, 0.006))), 0U);
}

TEST(DuplicateNodes, NotWhereSomethingJoinsThem) {
  RuleDeck deck = halves(2);
  deck.raw("SET_NODE_LIST", "9\n3,101,6,104,9,107,12,110\n15,113\n");
  RuleDeck rigid = deck, constrained = deck, tied = deck, springs = deck;
  EXPECT_EQ(listed(run_rule("GC507", deck)), 5U);
  EXPECT_EQ(listed(run_rule("GC507", rigid.raw("CONSTRAINED_NODAL_RIGID_BODY", "50,0,9"))), 0U);
  EXPECT_EQ(listed(run_rule("GC507", constrained.raw("CONSTRAINED_JOINT_SPHERICAL", "3,101\n"))), 4U);
  tied.contact(2, "TIED_NODES_TO_SURFACE", "9,1,4,3");
  EXPECT_EQ(listed(run_rule("GC507", tied)), 0U);
  springs.raw("ELEMENT_DISCRETE", "70,9,3,101\n71,9,9,107\n").raw("PART", "springs\n9,9,9\n");
  springs.raw("SECTION_DISCRETE", "9\n").raw("MAT_SPRING_ELASTIC", "9,1.0\n");
  EXPECT_EQ(listed(run_rule("GC507", springs)), 3U);
}

TEST(DuplicateNodes, BodiesOfSolidsMayTouch) {
  RuleDeck apart, broken;
  apart.solid_part(1)
      .solid_part(2)
      .block(1, 1, 1, 1, 1, {0, 0, 0}, {5, 5, 5})
      .block(101, 2, 1, 1, 1, {5, 0, 0}, {5, 5, 5});
  EXPECT_EQ(listed(run_rule("GC507", apart.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U);
  broken.solid_part(1).block(1, 1, 1, 1, 1, {0, 0, 0}, {5, 5, 5}).block(101, 1, 1, 1, 1, {5, 0, 0}, {5, 5, 5});
  EXPECT_EQ(listed(run_rule("GC507", broken.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 4U);
}

// A crack runs along an edge; two sheets that meet in one corner, or lie half a foil's thickness apart, are none.
TEST(DuplicateNodes, NotCornersThatOnlyMeet) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 5, 5).plate(101, 1, 1, 1, Vector(5, 5, 0), 5, 5);
  EXPECT_EQ(listed(run_rule("GC507", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U);
}

/// Shells 1 2 3 4 and 2 5 6 3, and a triangle of another part on two of these nodes.
std::size_t triangle_on(std::int64_t a, std::int64_t b) {
  const std::map<std::int64_t, Vector> x{{1, {0, 0, 0}}, {2, {5, 0, 0}},  {3, {5, 5, 0}},
                                         {4, {0, 5, 0}}, {5, {10, 0, 0}}, {6, {10, 5, 0}}};
  RuleDeck deck;
  deck.shell_part(1, 0.1).shell_part(2, 0.1).node(22, x.at(a)).node(24, x.at(b)).node(25, {2, 2, 7});
  for (const auto& [id, at] : x) deck.node(id, at);
  deck.shell(1, 1, {1, 2, 3, 4}).shell(2, 1, {2, 5, 6, 3}).shell(3, 2, {22, 24, 25});
  return listed(run_rule("GC507", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
}

TEST(DuplicateNodes, AlongEdgesAndNotAlongDiagonals) {
  for (const auto& [a, b] : {std::pair{1, 2}, {2, 3}, {3, 4}, {4, 1}})
    EXPECT_EQ(triangle_on(a, b), 2U) << a << " " << b;
  for (const auto& [a, b] : {std::pair{1, 3}, {2, 4}}) EXPECT_EQ(triangle_on(a, b), 0U) << a << " " << b;
}

TEST(DuplicateNodes, NotSheetsOfFoil) {
  const auto sheets = [](double apart) {
    RuleDeck deck;
    deck.shell_part(1, 0.008).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 1, 2, 2, Vector(0, 0, apart), 5, 5);
    return listed(run_rule("GC507", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
  };
  EXPECT_EQ(sheets(0.0003), 9U);  // below a twentieth of the thickness: the same sheet twice
  EXPECT_EQ(sheets(0.004), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::duplicate_nodes_test
