#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_rigid_test {
namespace {

/// Plates 1 and 2 (z = 0 and 0.5), of steel or rigid; the nodes 11 to 14 of plate 2 are tied to plate 1.
Report plates(std::int64_t lower, std::int64_t upper, const std::string& type) {
  RuleDeck deck;
  deck.shell_part(1, 1, lower).shell_part(2, 1, upper);
  deck.plate(1, 1, 1, 1, Vector(0, 0, 0), 20, 20).plate(11, 2, 1, 1, Vector(5, 5, 0.5), 10, 10);
  return run_rule("GC206", deck.contact(1, type, "2,1,3,3"));
}

TEST(TieRigid, ConstraintsDoNotTakeRigidParts) {
  const Report tracked = plates(1, 2, "TIED_SURFACE_TO_SURFACE");
  ASSERT_EQ(listed(tracked), 1U);
  EXPECT_EQ(tracked.findings[0].count, 4U);
  EXPECT_EQ(tracked.findings[0].node, 11);
  EXPECT_EQ(tracked.findings[0].severity, Severity::error);
  EXPECT_NE(tracked.findings[0].message.find("4 nodes of rigid part 2"), std::string::npos)
      << tracked.findings[0].message;
  const Report reference = plates(2, 1, "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET");
  ASSERT_EQ(listed(reference), 1U);
  EXPECT_NE(reference.findings[0].message.find("4 nodes on segments of rigid part 1"), std::string::npos)
      << reference.findings[0].message;
}

TEST(TieRigid, PenaltyTakesThem) {
  EXPECT_EQ(listed(plates(1, 1, "TIED_SURFACE_TO_SURFACE")), 0U);
  for (const char* form : {"_OFFSET", "_BEAM_OFFSET"})
    EXPECT_EQ(listed(plates(1, 2, std::string("TIED_SHELL_EDGE_TO_SURFACE") + form)), 0U);
}

TEST(TieRigid, OnlyNodesThatWouldTie) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 2);
  deck.plate(1, 1, 1, 1, Vector(0, 0, 0), 20, 20).plate(11, 2, 1, 1, Vector(5, 5, 3), 10, 10);
  EXPECT_EQ(listed(run_rule("GC206", deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3"))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_rigid_test
