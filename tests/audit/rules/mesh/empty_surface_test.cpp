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

TEST(EmptySurface, ParticlesThatTheRunMakes) {
  const auto findings = [](const std::string& card1, const std::string& rule, const std::string& keyword,
                           const std::string& card) {
    RuleDeck deck;
    deck.shell_part(1, 1).solid_part(3).solid_part(4).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
    deck.block(101, 3, 1, 1, 1, Vector(0, 0, 2), Vector(5, 5, 5));
    deck.raw("SET_PART_LIST", "8\n7\n").raw("SET_PART_LIST", "9\n7,4\n").raw(keyword, card);
    return listed(run_rule(rule, deck.contact(1, "AUTOMATIC_NODES_TO_SURFACE", card1, "0.\n1.,1.\n")));
  };
  for (const char* keyword : {"DEFINE_ADAPTIVE_SOLID_TO_SPH", "DEFINE_ADAPTIVE_SOLID_TO_DES"})
    for (const char* card1 : {"7,1,3,3", "8,1,2,3"}) {
      EXPECT_EQ(findings(card1, "GC503", keyword, "3,0,1,7,7,1"), 0U) << keyword;
      EXPECT_EQ(findings(card1, "GC502", keyword, "3,0,1,7,7,1"), 0U) << keyword;
    }
  EXPECT_EQ(findings("7,1,3,3", "GC503", "DEFINE_ADAPTIVE_SOLID_TO_SPH_ID", "12\n3,0,1,7,7,1"), 0U);
  EXPECT_EQ(findings("7,1,3,3", "GC502", "DEFINE_ADAPTIVE_SOLID_TO_SPH", "3,0,1,6,6,1"), 3U)
      << "of another part; the contact and two sets name part 7";
  EXPECT_EQ(findings("9,1,2,3", "GC503", "DEFINE_ADAPTIVE_SOLID_TO_SPH", "3,0,1,7,7,1"), 1U) << "part 4 is just empty";
}

TEST(EmptySurface, NodesAreNoReferenceSurface) {
  EXPECT_EQ(found("AUTOMATIC_NODES_TO_SURFACE", "3,1,4,3"), 0U);
  EXPECT_EQ(found("AUTOMATIC_NODES_TO_SURFACE", "4,1,4,3"), 1U);
  EXPECT_EQ(found("AUTOMATIC_NODES_TO_SURFACE", "1,3,3,4"), 1U);
  EXPECT_EQ(found("TIED_NODES_TO_SURFACE", "3,3,4,4"), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::empty_surface_test
