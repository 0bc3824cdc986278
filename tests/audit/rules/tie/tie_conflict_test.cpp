#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_conflict_test {
namespace {

constexpr const char* cards = "0.\n1.,1.\n";
constexpr const char* cards_with_ipback = "0.\n1.,1.\n\n\n\n\n0,0,1\n";

// Nodes 50 and 51 between two plates 0.4 apart, each within 0.6 (0 + 1) of both.
RuleDeck sandwich() {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1);
  deck.plate(1, 1, 1, 1, Vector(0, 0, 0), 10, 10).plate(11, 2, 1, 1, Vector(0, 0, 0.4), 10, 10);
  deck.node(50, Vector(3, 4, 0.2)).node(51, Vector(6, 4, 0.2)).raw("SET_NODE_LIST", "7\n50,51\n");
  return deck;
}

TEST(TieConflict, NamesTheFirstContact) {
  RuleDeck deck = sandwich();
  deck.contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3").contact(4, "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", "7,2,4,3");
  const Report report = run_rule("GC203", deck);
  ASSERT_EQ(listed(report), 1U);
  const Finding& finding = report.findings[0];
  EXPECT_EQ(finding.contact, 4);
  EXPECT_EQ(finding.node, 50);
  EXPECT_EQ(finding.count, 2U);
  EXPECT_NE(finding.message.find("2 nodes (50, 51)"), std::string::npos) << finding.message;
  EXPECT_NE(finding.message.find("contact 3"), std::string::npos) << finding.message;
}

TEST(TieConflict, FiveNodesAreNamedAndTheRestIsNot) {
  const auto message = [](int nodes) {
    RuleDeck deck = sandwich();
    std::string ids;
    for (int i = 0; i < nodes; ++i) {
      deck.node(60 + i, Vector(2 + 0.5 * i, 6, 0.2));
      ids += fmt::format("{}{}", i > 0 ? "," : "", 60 + i);
    }
    deck.raw("SET_NODE_LIST", "8\n" + ids + "\n").contact(3, "TIED_NODES_TO_SURFACE", "8,1,4,3");
    deck.contact(4, "TIED_NODES_TO_SURFACE", "8,2,4,3");
    return run_rule("GC203", deck).findings.at(0).message;
  };
  EXPECT_NE(message(1).find("1 node (60)"), std::string::npos) << message(1);
  EXPECT_NE(message(5).find("5 nodes (60, 61, 62, 63, 64)"), std::string::npos) << message(5);
  EXPECT_NE(message(6).find("6 nodes (60, 61, 62, 63, 64, ...)"), std::string::npos) << message(6);
}

TEST(TieConflict, PenaltyTakesAnyNode) {
  RuleDeck offset = sandwich();
  offset.contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3").contact(4, "TIED_NODES_TO_SURFACE_OFFSET", "7,2,4,3");
  EXPECT_EQ(listed(run_rule("GC203", offset)), 0U);
  for (const char* last : {cards, cards_with_ipback}) {
    RuleDeck deck = sandwich();
    deck.contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3").contact(4, "TIED_NODES_TO_SURFACE", "7,2,4,3", last);
    EXPECT_EQ(listed(run_rule("GC203", deck)), last == cards ? 1U : 0U);
  }
}

TEST(TieConflict, NodalRigidBodiesAndExtraNodes) {
  RuleDeck body = sandwich();
  body.raw("SET_NODE_LIST", "8\n51\n").raw("CONSTRAINED_NODAL_RIGID_BODY", "99,0,8\n");
  body.contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  const Report report = run_rule("GC203", body);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].node, 51);
  EXPECT_EQ(report.findings[0].count, 1U);
  EXPECT_NE(report.findings[0].message.find("nodal rigid body 99"), std::string::npos) << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC206", body)), 0U);  // each rule has its own

  RuleDeck extra = sandwich();
  extra.shell_part(5, 1, 2)
      .raw("CONSTRAINED_EXTRA_NODES_NODE", "5,50\n")
      .contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  const Report named = run_rule("GC203", extra);
  ASSERT_EQ(listed(named), 1U);
  EXPECT_NE(named.findings[0].message.find("rigid part 5"), std::string::npos) << named.findings[0].message;
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_conflict_test
