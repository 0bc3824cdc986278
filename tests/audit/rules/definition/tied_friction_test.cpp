#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tied_friction_test {
namespace {

Report with_friction(const std::string& keyword, const std::string& card2) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, 0), 5, 5);
  return run_rule("GC406", deck.contact(1, keyword, "1,2,3,3", card2 + "\n1.,1.\n1.,1.\n"));
}

TEST(TiedFriction, OnlyInTiesThatNeverSlide) {
  for (const char* keyword : {"TIED_SURFACE_TO_SURFACE", "TIED_NODES_TO_SURFACE_OFFSET",
                              "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", "SPOTWELD"}) {
    EXPECT_EQ(listed(with_friction(keyword, "0.2,0.1")), 1U) << keyword;
    EXPECT_EQ(listed(with_friction(keyword, "0.0,0.0,0.,0.,20.")), 0U) << keyword;
  }
  for (const char* keyword :
       {"AUTOMATIC_SURFACE_TO_SURFACE", "TIEBREAK_SURFACE_TO_SURFACE", "TIED_SURFACE_TO_SURFACE_FAILURE",
        "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "AUTOMATIC_SINGLE_SURFACE_TIEBREAK"})
    EXPECT_EQ(listed(with_friction(keyword, "0.2,0.1")), 0U) << keyword;
}

}  // namespace
}  // namespace gapcheck::audit_test::tied_friction_test
