#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_fine_reference_test {
namespace {

struct Setup {
  double size = 2;  ///< edges of the reference side; those of the tracked side are 4
  int tracked_material = 1, reference_material = 1;
  std::string keyword = "TIED_SURFACE_TO_SURFACE", card1 = "1,2,3,3";
};

/// 2 x 2 shells of part 1, part 2 below them; all nine nodes of part 1 lie over part 2.
Report plates(const Setup& setup) {
  RuleDeck deck;
  deck.shell_part(1, 1, setup.tracked_material).shell_part(2, 1, setup.reference_material);
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0.5), 4, 4);
  const int count = static_cast<int>(12 / setup.size);
  deck.plate(101, 2, count, count, Vector(-1, -1, 0), setup.size, setup.size);
  deck.raw("MAT_ELASTIC", "3,1.e-9,100.,0.3").raw("MAT_SPOTWELD", "4,7.85e-9,210000.,0.3");
  deck.raw("SET_NODE_LIST", "5\n1,2,3,4,5,6,7,8\n9\n").raw("SET_NODE_LIST", "6\n1,2,3\n");
  return run_rule("GC211", deck.contact(8, setup.keyword, setup.card1));
}

TEST(TieFineReference, ReferenceSideMustNotBeFiner) {
  const Report report = plates({});
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 8);
  EXPECT_EQ(f.node, 1);
  EXPECT_EQ(f.part, 1);
  EXPECT_EQ(f.element_part, 2);
  EXPECT_NE(f.message.find("2 times finer than the tracked side A (mean edges 2 and 4)"), std::string::npos)
      << f.message;
  EXPECT_EQ(listed(plates({.size = 3})), 0U);    // 4 / 3 < 1.5
  EXPECT_EQ(listed(plates({.size = 2.4})), 1U);  // 4 / 2.4 > 1.5
  EXPECT_EQ(listed(plates({.size = 6})), 0U);
}

TEST(TieFineReference, NodeSetsToo) {
  EXPECT_EQ(listed(plates({.keyword = "TIED_NODES_TO_SURFACE", .card1 = "5,2,4,3"})), 1U);
  EXPECT_EQ(listed(plates({.keyword = "TIED_SHELL_EDGE_TO_SURFACE", .card1 = "5,2,4,3"})), 1U);
  // The first row of nodes alone has no shell between its nodes.
  EXPECT_EQ(listed(plates({.keyword = "TIED_SHELL_EDGE_TO_SURFACE", .card1 = "6,2,4,3"})), 0U);
}

TEST(TieFineReference, OnlyTheJointCounts) {
  // Part 1 is fine at the joint, which is all that part 2 reaches, and coarse elsewhere.
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 4, 4, Vector(0, 0, 0.5), 2, 2);
  deck.plate(51, 1, 3, 3, Vector(100, 0, 0.5), 20, 20).plate(101, 2, 5, 5, Vector(-1, -1, 0), 2, 2);
  EXPECT_EQ(listed(run_rule("GC211", deck.contact(1, "TIED_SURFACE_TO_SURFACE", "1,2,3,3"))), 0U);
}

TEST(TieFineReference, SimilarMaterialsOnly) {
  EXPECT_EQ(listed(plates({.tracked_material = 3})), 0U);    // the reference is 2100 times as stiff
  EXPECT_EQ(listed(plates({.reference_material = 3})), 1U);  // the tracked side is
  EXPECT_EQ(listed(plates({.tracked_material = 4})), 0U);    // spotwelds
  EXPECT_EQ(listed(plates({.reference_material = 2, .keyword = "TIED_SURFACE_TO_SURFACE_OFFSET"})), 0U);  // rigid
  EXPECT_EQ(listed(plates({.tracked_material = 2, .keyword = "TIED_SURFACE_TO_SURFACE_OFFSET"})), 1U);
}

TEST(TieFineReference, TiesOnly) {
  EXPECT_EQ(listed(plates({.keyword = "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"})), 0U);
  EXPECT_EQ(listed(plates({.keyword = "TIED_SURFACE_TO_SURFACE_OFFSET"})), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_fine_reference_test
