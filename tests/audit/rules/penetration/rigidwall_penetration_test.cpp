#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::rigidwall_penetration_test {
namespace {

/// A plate 0 to 10 in x and y at z = 2 (nodes 1 to 9, 5 apart), and a node without element.
RuleDeck plate(std::int64_t material = 1) {
  RuleDeck deck;
  deck.shell_part(1, 1, material).plate(1, 1, 2, 2, Vector(0, 0, 2), 5, 5).node(50, {0, 0, 0});
  return deck;
}
Report wall(const std::string& options, const std::string& lines, RuleDeck deck = plate()) {
  return run_rule("GC110", deck.raw("RIGIDWALL_" + options, lines));
}

TEST(RigidwallPenetration, BehindAPlane) {
  const Report report = wall("PLANAR", "0\n0.,0.,3.5,0.,0.,9.\n");
  ASSERT_EQ(listed(report), 9U);
  EXPECT_EQ(report.findings[0].node, 1);
  EXPECT_DOUBLE_EQ(report.findings[0].penetration, 1.5);
  EXPECT_EQ(*report.findings[0].point, Vector(0, 0, 3.5));
  EXPECT_NE(report.findings[0].message.find("node 1 is 1.5 deep in rigid wall 1"), std::string::npos);
  EXPECT_EQ(listed(wall("PLANAR", "0\n0.,0.,2.0,0.,0.,9.\n")), 0U);   // touches
  EXPECT_EQ(listed(wall("PLANAR", "0\n0.,0.,3.5,0.,0.,-9.\n")), 0U);  // the other way round
}

TEST(RigidwallPenetration, WallsWithoutAnIdAreNumbered) {
  RuleDeck deck = plate();
  deck.raw("RIGIDWALL_PLANAR", "0\n0.,0.,0.,0.,0.,1.\n");
  deck.raw("RIGIDWALL_PLANAR", "0\n1.,0.,0.,2.,0.,0.\n").raw("RIGIDWALL_PLANAR_ID", "77,side\n0\n0.,0.5,0.,0.,2.,0.\n");
  const Report report = run_rule("GC110", deck);
  ASSERT_EQ(listed(report), 6U);  // three nodes each at x = 0 and y = 0
  std::map<std::string, int> walls;
  for (const Finding& f : report.findings) {
    const std::size_t in = f.message.find("rigid wall ");
    ++walls[f.message.substr(in, f.message.find(';') - in)];
  }
  EXPECT_EQ(walls, (std::map<std::string, int>{{"rigid wall 2", 3}, {"rigid wall 77 \"side\"", 3}}));
}

TEST(RigidwallPenetration, OnlyItsNodes) {
  const std::string plane = "0.,0.,3.5,0.,0.,9.\n";
  const auto with = [&](const std::string& card1) {
    RuleDeck deck = plate();
    deck.raw("SET_NODE_LIST", "3\n1,2,50\n").raw("SET_NODE_LIST", "4\n1\n");
    return run_rule("GC110", deck.raw("DEFINE_BOX", "5,4.,99.,-1.,1.,-9.,9.\n").raw("RIGIDWALL_PLANAR", card1 + plane));
  };
  EXPECT_EQ(listed(with("3\n")), 3U);  // the node without element too: somebody picked it
  EXPECT_EQ(listed(with("3,4\n")), 2U);
  EXPECT_EQ(listed(with("0,4\n")), 8U);
  EXPECT_EQ(listed(with("0,0,5\n")), 2U);  // x = 5 and 10, y = 0
  EXPECT_EQ(listed(with("0,0,0,1.\n")), 0U);
  EXPECT_EQ(listed(with("0,0,0,2.\n")), 9U);
  EXPECT_EQ(listed(with("0,0,0,0.,1.\n")), 0U);  // born later
}

TEST(RigidwallPenetration, RigidNodesOnlyWithAPenalty) {
  const std::string lines = "0\n0.,0.,3.5,0.,0.,9.\n";
  EXPECT_EQ(listed(wall("PLANAR", lines, plate(2))), 0U);
  EXPECT_EQ(listed(wall("PLANAR", lines, plate(2).raw("CONTROL_CONTACT", "0.1,1.0\n"))), 9U);
}

TEST(RigidwallPenetration, FiniteOnlyInsideTheRectangle) {
  // l along x to 6, m = n x l along y to 4: nodes 1 and 2.
  const Report report = wall("PLANAR_FINITE_MOVING", "0\n-1.,-1.,3.5,-1.,-1.,9.\n9.,-1.,3.5,7.,5.\n1.,1.\n");
  ASSERT_EQ(listed(report), 2U);
  EXPECT_EQ(report.findings[0].node, 1);
  EXPECT_EQ(report.findings[1].node, 2);
  EXPECT_EQ(listed(wall("GEOMETRIC_FLAT", "0\n-1.,-1.,3.5,-1.,-1.,9.\n9.,-1.,3.5,7.,5.\n")), 2U);
}

TEST(RigidwallPenetration, Prism) {
  // From z = 3.5 down to 1.5, x -1 to 6, y -1 to 4: the nearest face of node 1 (0, 0, 2) is the lower one.
  const Report report = wall("GEOMETRIC_PRISM", "0\n-1.,-1.,3.5,-1.,-1.,9.\n9.,-1.,3.5,7.,5.,2.\n");
  ASSERT_EQ(listed(report), 2U);
  EXPECT_DOUBLE_EQ(report.findings[0].penetration, 0.5);
  EXPECT_EQ(listed(wall("GEOMETRIC_PRISM", "0\n-1.,-1.,3.5,-1.,-1.,9.\n9.,-1.,3.5,7.,5.,1.\n")), 0U);
}

TEST(RigidwallPenetration, CylinderAndSphere) {
  // Axis along x at y = 5, z = 0: the nodes 4, 5, 6 are 2 away from it.
  const Report report = wall("GEOMETRIC_CYLINDER_ID", "8,post\n0\n-1.,5.,0.,9.,5.,0.\n2.5\n");
  ASSERT_EQ(listed(report), 3U);
  EXPECT_EQ(report.findings[0].node, 4);
  EXPECT_DOUBLE_EQ(report.findings[0].penetration, 0.5);
  EXPECT_TRUE(report.findings[0].point->isApprox(Vector(0, 5, 2.5)));
  EXPECT_EQ(listed(wall("GEOMETRIC_CYLINDER", "0\n-1.,5.,0.,9.,5.,0.\n2.5,7.\n")), 2U);  // ends at x = 6
  EXPECT_EQ(listed(wall("GEOMETRIC_CYLINDER", "0\n-1.,5.,0.,9.,5.,0.\n1.9\n")), 0U);
  EXPECT_EQ(listed(wall("GEOMETRIC_SPHERE_MOTION", "0\n5.,5.,0.,5.,5.,1.\n2.5\n1,0,0.,0.,1.\n")), 1U);
  EXPECT_EQ(listed(wall("GEOMETRIC_SPHERE_INTERIOR", "0\n5.,5.,0.,5.,5.,1.\n2.5\n")), 8U);
}

}  // namespace
}  // namespace gapcheck::audit_test::rigidwall_penetration_test
