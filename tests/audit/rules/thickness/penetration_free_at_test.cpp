#include <functional>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::penetration_free_at_test {
namespace {

using Make = std::function<RuleDeck(double sst)>;  // 0: none

/// SST as the finding prints it; -1 if there is no finding with one.
double printed(const Report& report) {
  if (report.findings.size() != 1) return -1;
  const std::string& text = report.findings[0].message;
  const auto at = text.find("<= ");
  return at == std::string::npos ? -1 : std::stod(text.substr(at + 3));
}

std::size_t penetrations(const RuleDeck& deck) { return run_rule("GC10", deck).penetrations.size(); }

/// Nothing penetrates with the SST printed; with 1 % more (`sharp`) something does.
void verify(const Make& make, double expected, bool sharp = true) {
  const double sst = printed(run_rule("GC308", make(0)));
  EXPECT_NEAR(sst, expected, 1e-3 * expected);
  EXPECT_LE(sst, expected * (1 + 1e-12));
  EXPECT_GT(penetrations(make(0)), 0U);
  EXPECT_EQ(penetrations(make(sst)), 0U);
  if (!sharp) return;
  EXPECT_GT(penetrations(make(1.01 * sst)), 0U);
}

RuleDeck plates(double lower, double upper, double gap) {
  RuleDeck deck;
  deck.shell_part(1, lower).shell_part(2, upper).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  return deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
}

std::string cards(double sst) { return fmt::format("0.\n1.,1.,{},{}\n", sst, sst); }

TEST(PenetrationFreeAt, TwoPlates) {
  const auto single = [](double sst) {
    return plates(1, 1, 0.7).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", cards(sst));
  };
  verify(single, 0.7);
  const auto two = [](double sst) {
    return plates(1, 1, 1. / 3).contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", cards(sst));
  };
  verify(two, 1. / 3);
  EXPECT_EQ(run_rule("GC308", single(0)).findings[0].count, 18U);
  EXPECT_EQ(listed(run_rule("GC308", plates(1, 1, 1).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"))), 0U);
}

/// Node 50 alone above a plate of thickness 1.
RuleDeck node_above(double height, double sst, const std::string& keyword = "AUTOMATIC_NODES_TO_SURFACE") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).node(50, Vector(2, 2, height));
  return deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, keyword, "7,1,4,3", cards(sst));
}

TEST(PenetrationFreeAt, ASingleNode) {
  // A node without an element has no thickness but SST, so that h = (SST + MST) / 2.
  const auto make = [](double sst) { return node_above(0.3, sst); };
  verify(make, 0.3);
  const Report report = run_rule("GC308", make(0));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.count, 1U);
  EXPECT_EQ(f.node, 50);
  EXPECT_EQ(f.element, 1);
  EXPECT_EQ(f.element_part, 1);
  ASSERT_TRUE(f.point);
  EXPECT_EQ(*f.point, Vector(2, 2, 0.3));
  EXPECT_NE(f.message.find("the closest is node 50, 0.3 from element 1"), std::string::npos) << f.message;
}

TEST(PenetrationFreeAt, ANodeThatOnlyTheNewThicknessReaches) {
  // Node 50 penetrates at 0.7 of 1; with SST = 0.7 node 51, 0.4 above a thin plate, would.
  const auto make = [](double sst) {
    RuleDeck deck;
    deck.shell_part(1, 2).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).node(50, Vector(2, 2, 0.7));
    deck.shell_part(3, 0.1).plate(201, 3, 2, 2, Vector(0, 0, 40), 5, 5).node(51, Vector(2, 2, 40.4));
    deck.raw("SET_NODE_LIST", "7\n50,51\n").raw("SET_PART_LIST", "8\n1,3\n");
    return deck.contact(1, "AUTOMATIC_NODES_TO_SURFACE", "7,8,4,2", cards(sst));
  };
  verify(make, 0.4);
  const Finding f = run_rule("GC308", make(0)).findings.at(0);
  EXPECT_EQ(f.node, 51);
  EXPECT_EQ(f.element, 201);
  EXPECT_NE(f.message.find("<= 0.4; the closest is node 51, 0.4 from element 201"), std::string::npos) << f.message;
}

TEST(PenetrationFreeAt, ThinPartsThatSstWouldThicken) {
  // The thick plates penetrate at 1.5 of 2; with SST = 1.5 the thin ones, 0.4 apart, would.
  const auto make = [](double sst) {
    RuleDeck deck = plates(2, 2, 1.5);
    deck.shell_part(3, 0.1).plate(201, 3, 2, 2, Vector(0, 0, 40), 5, 5).plate(301, 3, 2, 2, Vector(0, 0, 40.4), 5, 5);
    return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", cards(sst));
  };
  verify(make, 0.4);
}

TEST(PenetrationFreeAt, NodesMovedByTheFirstSideAndByOtherContacts) {
  // Both sides of contact 1 and all of contact 2 are found on nodes that were moved.
  const auto make = [](double sst) {
    RuleDeck deck = plates(1, 1, 0.6);
    deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", cards(sst));
    return deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", cards(sst));
  };
  const Report report = run_rule("GC308", make(0));
  ASSERT_GE(report.findings.size(), 1U);
  for (const Finding& f : report.findings) EXPECT_NE(f.message.find("<= 0.6;"), std::string::npos) << f.message;
  EXPECT_EQ(penetrations(make(0.6)), 0U);
}

RuleDeck on_block(double gap, double sst) {
  RuleDeck deck;
  deck.solid_part(1).shell_part(2, 1).block(1, 1, 2, 2, 1, Vector(0, 0, -5), Vector(5, 5, 5));
  deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
  return deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", cards(sst));
}

TEST(PenetrationFreeAt, ShellOnSolidTakesHalfOfSst) {
  verify([](double sst) { return on_block(0.2, sst); }, 0.4);
}

TEST(PenetrationFreeAt, SafeWhereShellsAndSolidsAreMixed) {
  const auto make = [](double sst) {
    RuleDeck deck;
    deck.solid_part(1).shell_part(2, 1).block(1, 1, 2, 2, 1, Vector(0, 0, -5), Vector(5, 5, 5));
    deck.plate(101, 2, 2, 2, Vector(0, 0, 0.2), 5, 5);
    return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", cards(sst));
  };
  verify(make, 0.2, false);
}

TEST(PenetrationFreeAt, NodesOnTheSegmentCannotBeFreed) {
  const Report report = run_rule("GC308", plates(1, 1, 0).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("no SST makes it free: 18 of 18"), std::string::npos)
      << report.findings[0].message;
  const Report behind = run_rule("GC308", on_block(-0.1, 0));
  ASSERT_EQ(listed(behind), 1U);
  EXPECT_NE(behind.findings[0].message.find("0.1 behind"), std::string::npos) << behind.findings[0].message;
}

// As in fix, which proposes no thickness there.
TEST(PenetrationFreeAt, NoThicknessThatNobodyCanUse) {
  const auto message = [](double gap) {
    const Report report = run_rule("GC308", plates(1, 1, gap).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"));
    return report.findings.empty() ? "" : report.findings[0].message;
  };
  EXPECT_EQ(message(1e-4).find("no useful SST makes it free: the closest of 18 penetrating nodes, node "), 0U)
      << message(1e-4);
  EXPECT_NE(message(1e-4).find(", is 0.0001 from element "), std::string::npos) << message(1e-4);
  EXPECT_EQ(message(0.5).find("free of penetrations with SST <= 0.5"), 0U) << message(0.5);
}

TEST(PenetrationFreeAt, UnitsTellIfTheRecommendedValueIsReached) {
  audit::AuditOptions options;
  options.millimetre = 1;
  const auto message = [&](double gap) {
    return run_rule("GC308", plates(1, 1, gap).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"), options)
        .findings.at(0)
        .message;
  };
  EXPECT_NE(message(0.4).find("0.5 mm)"), std::string::npos);
  EXPECT_EQ(message(0.5).find("0.5 mm"), std::string::npos);
  options.millimetre = 0;  // the plates are steel in mm, t and s
  EXPECT_NE(message(0.4).find("0.5 mm, taking the unit of length for mm,"), std::string::npos) << message(0.4);
  EXPECT_EQ(message(0.5).find("0.5 mm"), std::string::npos);
}

/// Plates 0.5 apart; part 3 has this OPTT (0: none).
RuleDeck with_optt(double optt, double sst) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 3, 2, 2, Vector(0, 0, 0.5), 5, 5);
  deck.raw("SECTION_SHELL", "3,2,0.833,5\n0.25\n");
  deck.raw("PART_CONTACT", fmt::format("part 3\n3,3,1\n0.,0.,0.,0.,{}\n", optt));
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", cards(sst));
}

TEST(PenetrationFreeAt, OpttIsMeantToGo) {
  const Report report = run_rule("GC308", with_optt(1, 0));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("free of penetrations with OPTT = 0 and SST <= 0.5;"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(penetrations(with_optt(0, 0.5)), 0U);
  EXPECT_GT(penetrations(with_optt(0, 0.505)), 0U);
}

TEST(PenetrationFreeAt, WithoutOpttThinPartsBecomeThicker) {
  // OPTT keeps two foils 0.1 apart free that SST = 0.5 would not.
  const auto make = [](double optt, double sst) {
    RuleDeck deck = with_optt(1, sst);
    deck.raw("PART_CONTACT", fmt::format("part 4\n4,3,1\n0.,0.,0.,0.,{}\n", optt));
    return deck.plate(201, 4, 2, 2, Vector(0, 0, 40), 5, 5).plate(301, 4, 2, 2, Vector(0, 0, 40.1), 5, 5);
  };
  const Report report = run_rule("GC308", make(0.05, 0));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("OPTT = 0 and SST <= 0.1;"), std::string::npos)
      << report.findings[0].message;
}

/// A plate above a block whose faces are coated.
RuleDeck coated(double gap, double coating, double sst, const std::string& keyword = "AUTOMATIC_SURFACE_TO_SURFACE") {
  RuleDeck deck;
  deck.solid_part(1).shell_part(2, 1).block(1, 1, 2, 2, 1, Vector(0, 0, -5), Vector(5, 5, 5));
  deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
  return deck.contact(1, keyword, "2,1,3,3", cards(sst) + "0\n" + fmt::format(",,,,,,{}\n", coating));
}

TEST(PenetrationFreeAt, CoatedSolidsKeepTheirHalf) {
  // d = 0.55 = 0.2 / 2 + SST / 2
  verify([](double sst) { return coated(0.55, 0.2, sst); }, 0.9);
  verify([](double sst) { return coated(0.55, 0.2, sst, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"); }, 0.9);
  const Report report = run_rule("GC308", coated(0.3, 0.8, 0));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("SLDTHK = 0.8 of solids alone makes 9 of 9 nodes penetrate; with SLDTHK "
                                            "<= 0.6"),
            std::string::npos)
      << report.findings[0].message;
}

}  // namespace
}  // namespace gapcheck::audit_test::penetration_free_at_test
