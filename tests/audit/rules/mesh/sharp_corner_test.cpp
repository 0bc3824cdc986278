#include <cmath>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::sharp_corner_test {
namespace {

constexpr double per_degree = 3.14159265358979323846 / 180;

/// Two rows of two shells that share the nodes 1, 2, 3, with this angle between them; the second row's nodes run either
/// way.
RuleDeck hinge_deck(double degrees, bool turned = false, std::int64_t material = 1) {
  RuleDeck deck;
  deck.shell_part(1, 0.1, material);
  for (int i = 0; i < 3; ++i)
    deck.node(1 + i, {10.0 * i, 0, 0})
        .node(11 + i, {10.0 * i, 10, 0})
        .node(21 + i, {10.0 * i, 10 * std::cos(degrees * per_degree), 10 * std::sin(degrees * per_degree)});
  for (int i = 0; i < 2; ++i) {
    deck.shell(1 + i, 1, {1 + i, 2 + i, 12 + i, 11 + i});
    if (turned)
      deck.shell(3 + i, 1, {2 + i, 1 + i, 21 + i, 22 + i});
    else
      deck.shell(3 + i, 1, {1 + i, 2 + i, 22 + i, 21 + i});
  }
  return deck;
}

Report hinge(double degrees, bool turned = false) {
  return run_rule("GC512", hinge_deck(degrees, turned).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
}

TEST(SharpCorner, BelowThirtyDegrees) {
  for (const bool turned : {false, true}) {
    const Report report = hinge(20, turned);
    ASSERT_EQ(listed(report), 2U);
    EXPECT_EQ(report.findings[0].element, 1);
    EXPECT_NE(report.findings[0].message.find("shell 1 of part 1 and shell 3 of part 1 meet at 20.0 degrees"),
              std::string::npos)
        << report.findings[0].message;
    EXPECT_EQ(listed(hinge(29.9, turned)), 2U);
    EXPECT_EQ(listed(hinge(30.1, turned)), 0U);
    EXPECT_EQ(listed(hinge(180, turned)), 0U);
  }
}

TEST(SharpCorner, WithinRigidBodiesOnlyNearDeformableNodes) {
  const auto found = [](std::int64_t material) {
    return listed(run_rule("GC512", hinge_deck(20, false, material).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
  };
  EXPECT_EQ(found(1), 2U);
  EXPECT_EQ(found(2), 0U);
  // Something deformable nearer to the edge than its segments are long (10): the edge matters.
  const auto near = [](double z) {
    RuleDeck deck = hinge_deck(20, false, 2);
    deck.shell_part(2, 0.1).plate(101, 2, 4, 1, Vector(-5, -8, z), 10, 2);
    return listed(run_rule("GC512", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
  };
  EXPECT_EQ(near(-6), 2U);  // sqrt(6² + 6²) = 8.5
  EXPECT_EQ(near(-9), 0U);  // 10.8
  EXPECT_EQ(near(-90), 0U);
  // A rigid sheet and a deformable one that hangs on its edge.
  RuleDeck both;
  both.shell_part(1, 0.1, 2).shell_part(2, 0.1).node(1, {0, 0, 0}).node(2, {10, 0, 0}).node(3, {10, 10, 0});
  both.node(4, {0, 10, 0}).node(5, {10, 10, 2}).node(6, {0, 10, 2}).shell(1, 1, {1, 2, 3, 4}).shell(2, 2, {1, 2, 5, 6});
  EXPECT_EQ(listed(run_rule("GC512", both.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 1U);
}

// The cosine of the angle may come out a little above 1.
TEST(SharpCorner, FoldedFlat) {
  for (int turn = 0; turn < 40; ++turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    const auto at = [&](double x, double y) { return Vector(c * x - s * y, s * x + c * y, 0.7 * x + 0.3 * y); };
    RuleDeck deck;
    deck.shell_part(1, 0.1).node(1, at(0, 0)).node(2, at(10, 0)).node(3, at(10, 10)).node(4, at(0, 10));
    deck.node(5, at(10, 7)).node(6, at(0, 7)).shell(1, 1, {1, 2, 3, 4}).shell(2, 1, {1, 2, 5, 6});
    const Report report = run_rule("GC512", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
    ASSERT_EQ(listed(report), 1U) << turn;
    EXPECT_NE(report.findings[0].message.find("meet at 0.0 degrees"), std::string::npos) << report.findings[0].message;
  }
}

TEST(SharpCorner, NotAShellOnASolid) {
  RuleDeck deck;
  deck.solid_part(1).shell_part(2, 0.1).block(1, 1, 1, 1, 1, {0, 0, 0}, {5, 5, 5}).shell(50, 2, {1, 2, 4, 3});
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0").contact(2, "AUTOMATIC_SINGLE_SURFACE", "2,0,3,0");
  EXPECT_EQ(listed(run_rule("GC512", deck)), 0U);
}

TEST(SharpCorner, NotInTiesAndNotAtSeamsOfFabric) {
  const auto tied = [](RuleDeck deck) {
    deck.shell_part(2, 0.1).plate(101, 2, 1, 1, {0, 0, 0.05}, 10, 10);
    return deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3");
  };
  RuleDeck in_both = tied(hinge_deck(20));
  EXPECT_EQ(listed(run_rule("GC512", tied(hinge_deck(20)))), 0U);
  EXPECT_EQ(listed(run_rule("GC512", in_both.contact(2, "AUTOMATIC_SINGLE_SURFACE", "0"))), 2U);
  // One wing of the hinge is part 3, which is tied; part 1 alone is in the other contact.
  RuleDeck one_wing;
  one_wing.shell_part(1, 0.1).shell_part(2, 0.1).shell_part(3, 0.1).node(1, {0, 0, 0}).node(2, {10, 0, 0});
  one_wing.node(3, {10, 10, 0}).node(4, {0, 10, 0}).node(5, {10, 9.4, 3.4}).node(6, {0, 9.4, 3.4});
  one_wing.shell(1, 1, {1, 2, 3, 4}).shell(3, 3, {1, 2, 5, 6}).plate(101, 2, 1, 1, {0, 0, 0.05}, 10, 10);
  RuleDeck touched = one_wing.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0");
  EXPECT_EQ(listed(run_rule("GC512", one_wing.contact(2, "TIED_SURFACE_TO_SURFACE", "2,3,3,3"))), 0U);
  EXPECT_EQ(listed(run_rule("GC512", touched.contact(2, "AUTOMATIC_SINGLE_SURFACE", "3,0,3,0"))), 1U);
  RuleDeck fabric = hinge_deck(20, false, 3);
  fabric.raw("MAT_FABRIC", "3,1e-9,300.,300.,,0.3,0.3\n100.\n\n\n\n");
  EXPECT_EQ(listed(run_rule("GC512", fabric.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::sharp_corner_test
