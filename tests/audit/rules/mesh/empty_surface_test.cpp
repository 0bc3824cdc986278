#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::empty_surface_test {
namespace {

TEST(EmptySurface, APartWithoutElements) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0");
  EXPECT_EQ(listed(run_rule("GC503", deck)), 0U);
  deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "2,0,3,0");
  const Report report = run_rule("GC503", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 2);
}

/// Part 1 has elements, part 2 none; box 1 is around part 1, box 2 around nothing.
std::size_t found(const std::string& keyword, const std::string& card1, const std::string& behind = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.raw("DEFINE_BOX", "1,-1.,11.,-1.,11.,-1.,1.\n2,50.,60.,50.,60.,50.,60.\n").raw("SET_NODE_LIST", "3\n1,2\n");
  deck.raw("SET_NODE_LIST", "4\n");
  return listed(run_rule("GC503", deck.contact(1, keyword, card1, "0.\n1.,1.\n" + behind)));
}

TEST(EmptySurface, BothSidesOfAllKindsOfContact) {
  for (const char* keyword : {"AUTOMATIC_SURFACE_TO_SURFACE", "TIED_SURFACE_TO_SURFACE", "FORCE_TRANSDUCER_PENALTY",
                              "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"}) {
    EXPECT_EQ(found(keyword, "1,1,3,3"), 0U) << keyword;
    EXPECT_EQ(found(keyword, "2,1,3,3"), 1U) << keyword;
    EXPECT_EQ(found(keyword, "1,2,3,3"), 1U) << keyword;
    EXPECT_EQ(found(keyword, "1,1,3,3,1,1"), 0U) << keyword;
    EXPECT_EQ(found(keyword, "1,1,3,3,2,0"), 1U) << keyword;
    EXPECT_EQ(found(keyword, "1,1,3,3,0,2"), 1U) << keyword;
  }
  EXPECT_EQ(found("FORCE_TRANSDUCER_PENALTY", "1,0,3,0"), 0U);
  EXPECT_EQ(found("SINGLE_EDGE", "2,0,3,0"), 1U);
}

TEST(EmptySurface, NodesAreNoReferenceSurface) {
  EXPECT_EQ(found("AUTOMATIC_NODES_TO_SURFACE", "3,1,4,3"), 0U);
  EXPECT_EQ(found("AUTOMATIC_NODES_TO_SURFACE", "4,1,4,3"), 1U);
  EXPECT_EQ(found("AUTOMATIC_NODES_TO_SURFACE", "1,3,3,4"), 1U);
  EXPECT_EQ(found("TIED_NODES_TO_SURFACE", "3,3,4,4"), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::empty_surface_test
