#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_rotations_test {
namespace {

/// A plate (part 1) and one that stands on it (part 2, two shells) with nodes 51, 52, 53, tied by them.
RuleDeck standing_plate(const std::string& type) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  for (int i = 0; i < 3; ++i) deck.node(51 + i, Vector(3 + 6 * i, 5, 0)).node(61 + i, Vector(3 + 6 * i, 5, 10));
  deck.shell(51, 2, {51, 52, 62, 61}).shell(52, 2, {52, 53, 63, 62});
  deck.raw("SET_NODE_LIST", "7\n51,52,53\n").contact(1, type, "7,1,4,3");
  return deck;
}

TEST(TieRotations, ShellEdgesTiedByTranslations) {
  for (const char* type : {"TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE_OFFSET", "TIED_SURFACE_TO_SURFACE"}) {
    const Report report = run_rule("GC205", standing_plate(type));
    ASSERT_EQ(listed(report), 1U) << type;
    EXPECT_EQ(report.findings[0].count, 3U);
    EXPECT_EQ(report.findings[0].node, 51);
    EXPECT_EQ(report.findings[0].contact, 1);
  }
  for (const char* type : {"TIED_SHELL_EDGE_TO_SURFACE", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET",
                           "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", "TIEBREAK_NODES_TO_SURFACE"})
    EXPECT_EQ(listed(run_rule("GC205", standing_plate(type))), 0U) << type;
}

/// A brick on a plate; its lower nodes 101 to 104 are tied. `beam`: with a beam upwards from node 101.
RuleDeck brick(bool beam) {
  RuleDeck deck;
  deck.shell_part(1, 1).solid_part(2).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.block(101, 2, 1, 1, 1, Vector(4, 4, 0.1), Vector(5, 5, 5));
  if (beam) deck.beam_part(3, 2).beam(500, 3, 101, 105);
  return deck.raw("SET_NODE_LIST", "7\n101,102,103,104\n").contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3");
}

TEST(TieRotations, SolidsHaveNoneAndBeamsDo) {
  EXPECT_EQ(listed(run_rule("GC205", brick(false))), 0U);
  const Report report = run_rule("GC205", brick(true));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 1U);
  EXPECT_EQ(report.findings[0].node, 101);
}

// *PART_COMPOSITE has no section, but layers: 0.2 and 0.3 thick.
TEST(TieRotations, CompositesAndCoats) {
  const auto edge = [](const std::string& part) {
    RuleDeck deck;
    deck.shell_part(1, 1)
        .plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10)
        .raw(part.substr(0, part.find('\n')), part.substr(part.find('\n') + 1));
    deck.raw("MAT_NULL", "9,7.85e-9\n").raw("SECTION_SHELL", "9,2\n0.1\n");
    for (int i = 0; i < 2; ++i) deck.node(51 + i, Vector(3 + 6 * i, 5, 0)).node(61 + i, Vector(3 + 6 * i, 5, 10));
    deck.shell(51, 2, {51, 52, 62, 61}).raw("SET_NODE_LIST", "7\n51,52\n");
    return listed(run_rule("GC205", deck.contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3")));
  };
  EXPECT_EQ(edge("PART_COMPOSITE\nlayers\n2,2\n1,0.2,0.,0,1,0.3,0.,0\n"), 1U);
  EXPECT_EQ(edge("PART\nsheet\n2,9,1\n"), 1U);
  EXPECT_EQ(edge("PART\ncoat\n2,9,9\n"), 0U);
  EXPECT_EQ(edge("PART\nno section\n2,0,1\n"), 0U);
}

// A lying plate of which whole shells are tied turns with them; one more shell over the edge does not change that.
TEST(TieRotations, NotWhereWholeElementsAreTied) {
  const auto lying = [](const std::string& tied) {
    RuleDeck deck;
    deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
    deck.plate(51, 2, 3, 1, Vector(2, 2, 0.1), 5, 5);  // nodes 51 to 54 and 55 to 58
    deck.raw("SET_NODE_LIST", "7\n" + tied);
    return run_rule("GC205", deck.contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3"));
  };
  EXPECT_EQ(listed(lying("51,52,55,56\n")), 0U);
  const Report edge = lying("51,55\n");
  ASSERT_EQ(listed(edge), 1U);
  EXPECT_EQ(edge.findings[0].count, 2U);
  EXPECT_EQ(lying("51,52,55,56,54\n").findings.at(0).count, 1U);  // 54 is tied alone
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_rotations_test
