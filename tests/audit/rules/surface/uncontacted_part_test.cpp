#include <cmath>
#include <numbers>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::uncontacted_part_test {
namespace {

RuleDeck three_parts() {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 2).solid_part(3);
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 3, 2, Vector(0, 0, 9), 5, 5);
  return deck.block(201, 3, 1, 1, 1, Vector(0, 0, 20), Vector(1, 1, 1));
}

TEST(UncontactedPart, NamesPartsThatNoContactHas) {
  RuleDeck deck = three_parts();
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3");
  const Report report = run_rule("GC415", deck);
  ASSERT_EQ(listed(report), 2U);
  EXPECT_EQ(report.findings[0].part, 2);
  EXPECT_NE(report.findings[0].message.find("part 2 \"part 2\" (6 shells) is in no contact"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(report.findings[1].part, 3);
  EXPECT_EQ(report.findings[1].severity, Severity::note);
  deck.contact(2, "TIED_NODES_TO_SURFACE", "8,3,4,3").raw("SET_NODE_LIST", "8\n105\n");
  EXPECT_EQ(listed(run_rule("GC415", deck)), 0U);  // a node of part 2 is enough
}

TEST(UncontactedPart, SaysNothingWhereItCannotKnow) {
  EXPECT_EQ(listed(run_rule("GC415", three_parts())), 0U);  // no contact at all
  RuleDeck all = three_parts();
  EXPECT_EQ(listed(run_rule("GC415", all.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5"))), 0U);
  RuleDeck transducer = three_parts();
  transducer.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3").contact(2, "FORCE_TRANSDUCER_PENALTY", "2,3,3,3");
  EXPECT_EQ(listed(run_rule("GC415", transducer)), 2U);
  RuleDeck branch = three_parts();
  branch.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3").contact(2, "AUTOMATIC_SINGLE_SURFACE", "9,0,7");
  EXPECT_EQ(listed(run_rule("GC415", branch)), 2U);  // as for a part set that is not defined
  branch.raw("SET_PART_TREE", "9\ntree\n-2,10\n").raw("SET_PART_TREE", "10\nbelow\n-3\n");
  EXPECT_EQ(listed(run_rule("GC415", branch)), 0U);
}

TEST(UncontactedPart, NullAndSpotweldAreForOtherPurposes) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 8).solid_part(3, 9);
  deck.raw("MAT_NULL", "8,1.0e-9\n").raw("MAT_SPOTWELD", "9,7.85e-9,210000.,0.3,250.\n");
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 3, 2, Vector(0, 0, 9), 5, 5);
  deck.block(201, 3, 1, 1, 1, Vector(0, 0, 20), Vector(1, 1, 1)).contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3");
  EXPECT_EQ(listed(run_rule("GC415", deck)), 0U);
}

// A ring of rigid shells around a cylinder of radius 100, and the same as a deformable part.
TEST(UncontactedPart, NotAPictureOfARigidWall) {
  const auto ring = [](int material, double radius) {
    RuleDeck deck;
    deck.shell_part(1, 1).plate(1001, 1, 1, 1, Vector(500, 0, 0), 5, 5).shell_part(2, 1, material);
    for (int i = 0; i < 36; ++i) {
      const double angle = i * std::numbers::pi / 18;
      const Vector x(radius * std::cos(angle), radius * std::sin(angle), 0);
      deck.node(1 + i, x).node(101 + i, x + Vector(0, 0, 50));
      deck.shell(1 + i, 2, {1 + i, 1 + (i + 1) % 36, 101 + (i + 1) % 36, 101 + i});
    }
    deck.raw("RIGIDWALL_GEOMETRIC_CYLINDER", "0\n0.,0.,0.,0.,0.,1.\n100.,0.\n");
    return listed(run_rule("GC415", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3")));
  };
  EXPECT_EQ(ring(2, 100.5), 0U);
  EXPECT_EQ(ring(1, 100.5), 1U) << "not rigid";
  EXPECT_EQ(ring(2, 110), 1U) << "not on the wall";
}

TEST(UncontactedPart, ManyAreCounted) {
  RuleDeck deck;
  for (int p = 1; p <= 15; ++p) deck.shell_part(p, 1).plate(100 * p, p, 1, 1, Vector(0, 0, 9 * p), 5, 5);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3");
  const Report report = run_rule("GC415", deck);
  ASSERT_EQ(report.findings.size(), 11U);
  std::uint64_t rest = 0;
  for (const Finding& f : report.findings) rest = std::max(rest, f.count);
  EXPECT_EQ(rest, 4U);
}

}  // namespace
}  // namespace gapcheck::audit_test::uncontacted_part_test
