// What start expects of decks: who meets what and when, walls, what is not looked at, and what costs nothing.
#include "solver/loss/expected_contacts.hpp"

#include "solver/loss/impact_scene.hpp"

namespace gapcheck::solver::expected_contacts_test {
namespace {

std::string falling_sheet(double speed, const std::string& more = "", const ImpactContact& contact = {}) {
  return shell_sheet(1, 3, 5, 0) + shell_sheet(2, 2, 4, 2) + shell_part(1, 1, rigid_steel(1, 7)) +
         shell_part(2, 1, rigid_steel(2, 0, 7.85e-5)) + contact.text() + more + (speed > 0 ? thrown(2, speed) : "") +
         ends_at(1, 1e-4);
}

TEST(ExpectedContacts, NothingMovesAndNothingIsSearched) {
  const Expectation still(falling_sheet(0));
  EXPECT_TRUE(still.refused.empty()) << still.refused;
  EXPECT_FALSE(still.report.expected);
}

TEST(ExpectedContacts, TimeSpeedAndCountOfASheet) {
  const Expectation said(falling_sheet(10));
  ASSERT_EQ(said.all().contacts.size(), 1u);
  const ExpectedContact e = said.worst();
  EXPECT_EQ(e.part, 2);
  EXPECT_EQ(e.other_part, 1);
  EXPECT_EQ(e.nodes, 9u);
  EXPECT_EQ(e.node, 2001);
  EXPECT_NEAR(e.time, 0.1, 1e-12);
  EXPECT_NEAR(e.speed, 10, 1e-12);
  EXPECT_NEAR(e.in_step.value(), 10 * 1e-4 / 0.8, 1e-12);
  EXPECT_EQ(e.crossing, 0u);
  EXPECT_EQ(said.all().until, 1);
  EXPECT_GT(said.all().candidates, 0u);
  EXPECT_LE(said.all().closest_points, 2 * said.all().candidates) << "flat contact takes two closest points";
  // Nothing is reached before the end.
  EXPECT_TRUE(Expectation(falling_sheet(1)).all().contacts.empty());
}

TEST(ExpectedContacts, NodesThatCrossInOneStepHaveNoMargin) {
  const double speed = 1.25 * 0.8 / 1e-4;
  const ExpectedContact e = Expectation(falling_sheet(speed)).worst();
  EXPECT_EQ(e.crossing, 9u);
  EXPECT_NEAR(e.in_step.value(), 1.25, 1e-9);
  EXPECT_FALSE(e.margin);
  EXPECT_FALSE(e.low);
  EXPECT_EQ(e.reason, crossing_reason);
  // 0.8 h in two steps.
  EXPECT_NEAR(e.step.value(), 1e-4 / 2.5, 1e-15);
}

TEST(ExpectedContacts, ARampOfPrescribedVelocityIsFollowed) {
  // Acceleration 20: the gap of 1 is closed at sqrt(2 / 20).
  const std::string driven = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,0,1,-1.\n*DEFINE_CURVE\n1\n0.,0.\n1.,20.\n";
  const Expectation said(falling_sheet(0, driven));
  ASSERT_EQ(said.all().contacts.size(), 1u) << said.refused;
  const ExpectedContact e = said.worst();
  EXPECT_NEAR(e.time, std::sqrt(0.1), 1e-7);
  EXPECT_NEAR(e.speed, 20 * std::sqrt(0.1), 1e-6);
  EXPECT_FALSE(e.margin) << "its speed is prescribed along the normal, and nothing stops it";
  // Displacement of 2 in the time 1, in two pieces: 0.5 until 0.5, then 1.5.
  const std::string moved = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,2,1,-1.\n*DEFINE_CURVE\n1\n0.,0.\n0.5,0.5\n1.,2.\n";
  const ExpectedContact by_displacement = Expectation(falling_sheet(0, moved)).worst();
  EXPECT_NEAR(by_displacement.time, 0.5 + 0.5 / 3, 1e-7);
  EXPECT_NEAR(by_displacement.speed, 3, 1e-7);
}

TEST(ExpectedContacts, WhatIsNotFollowedIsSaid) {
  const std::string accelerated = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,1,1,-1.\n*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n";
  const Expectation said(falling_sheet(0, accelerated));
  ASSERT_TRUE(said.report.expected) << said.refused;
  EXPECT_TRUE(said.all().contacts.empty());
  ASSERT_EQ(said.all().not_looked_at.size(), 1u);
  EXPECT_EQ(said.all().not_looked_at[0].rfind("9 nodes whose prescribed motion", 0), 0u) << said.all().not_looked_at[0];
  const Expectation loaded(falling_sheet(10, "*LOAD_BODY_Z\n1,9.81e-3\n*DEFINE_CURVE\n1\n0.,1.\n100.,1.\n"));
  ASSERT_EQ(loaded.all().not_looked_at.size(), 1u) << loaded.refused;
  EXPECT_EQ(loaded.all().not_looked_at[0].rfind("loads", 0), 0u);
  ImpactContact mortar;
  mortar.type = "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR";
  const Expectation of_mortar(falling_sheet(10, "", mortar));
  ASSERT_TRUE(of_mortar.report.expected) << of_mortar.refused;
  ASSERT_EQ(of_mortar.all().not_looked_at.size(), 1u);
}

TEST(ExpectedContacts, BodiesThatMeetSomethingElseBeforeAreNotPredicted) {
  // A second plate halfway, above a corner of the first one.
  const std::string more = shell_sheet(3, 1, 4, 0.5) + shell_part(3, 1, rigid_steel(3, 7)) +
                           "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,3,3,3\n0.\n1.,1.\n";
  const Expectation said(falling_sheet(10, more));
  ASSERT_EQ(said.all().contacts.size(), 2u) << said.refused;
  for (const ExpectedContact& e : said.all().contacts) {
    EXPECT_FALSE(e.margin && e.other_part == 1) << "it has met part 3 by then";
    if (e.other_part == 1) {
      EXPECT_EQ(e.reason, "one of the two meets something else by then");
    }
  }
}

TEST(ExpectedContacts, ReasonsWhyNoMarginIsExact) {
  // It slides, it turns, the springs turn it, damping.
  const std::string sliding = "*INITIAL_VELOCITY_GENERATION\n2,2,0.,2.,0.,-10.\n0.,0.,0.,0.,0.,1.\n";
  EXPECT_EQ(Expectation(falling_sheet(0, sliding)).worst().reason, "it slides meanwhile");
  ImpactContact damped;
  damped.vdc = 20;
  EXPECT_EQ(Expectation(falling_sheet(10, "", damped)).worst().reason, "the contact has damping (VDC)");
  const std::string turning = "*INITIAL_VELOCITY_GENERATION\n2,2,5.,0.,0.,-10.\n0.,0.,2.,1.,0.,0.\n";
  const ExpectedContact turned = Expectation(falling_sheet(0, turning)).worst();
  EXPECT_FALSE(turned.margin);
  EXPECT_EQ(turned.reason, "it turns meanwhile");
  // Deeper than 1 the nodes of a block are nearer to the side faces of the one below.
  const std::string block = brick_block(1, 1, 1, 10, -10) + brick_block(2, 1, 1, 8, 2) +
                            solid_part(1, rigid_steel(1, 7)) + solid_part(2, rigid_steel(2)) +
                            ImpactContact{"AUTOMATIC_SURFACE_TO_SURFACE"}.text() + ends_at(1, 1e-5);
  EXPECT_TRUE(Expectation(block + thrown(2, 20)).worst().margin);
  const ExpectedContact deep = Expectation(block + thrown(2, 1000)).worst();
  EXPECT_FALSE(deep.margin);
  EXPECT_EQ(deep.reason, "its nodes come as deep as other faces");
  EXPECT_TRUE(deep.low);
  const std::string spinning = "*INITIAL_VELOCITY_GENERATION\n2,2,.01,0.,0.,-10.\n0.,0.,2.,0.,0.,1.\n";
  EXPECT_EQ(Expectation(falling_sheet(0, spinning)).worst().reason, "it slides meanwhile");
  // Half of the sheet is over the edge of the plate.
  std::string shifted = shell_sheet(1, 1, 8, 0) + shell_sheet(2, 2, 8, 2) + shell_part(1, 1, rigid_steel(1, 7)) +
                        shell_part(2, 1, rigid_steel(2, 0, 7.85e-5)) + ImpactContact{}.text() + ends_at(1, 1e-4);
  shifted += "*ELEMENT_MASS\n9001,2001,0.01\n" + thrown(2, 10);
  const ExpectedContact off = Expectation(shifted).worst();
  EXPECT_EQ(off.reason, "it turns meanwhile") << off.reason;
  EXPECT_TRUE(off.low) << "energy bounds it";
}

TEST(ExpectedContacts, FlatRigidWallsAreMet) {
  const std::string wall = "*RIGIDWALL_PLANAR\n0,0,0\n0.,0.,-3.,0.,0.,-2.\n0.\n";
  // Nodes of rigid bodies are not stopped; deforming ones are.
  const std::string deck =
      shell_sheet(2, 2, 4, 2) + shell_part(2, 1, elastic_steel(2)) + wall + thrown(2, 10) + ends_at(1);
  const Expectation said(deck);
  ASSERT_TRUE(said.report.expected) << said.refused;
  ASSERT_EQ(said.all().walls.size(), 1u);
  const ExpectedWall& met = said.all().walls[0];
  EXPECT_EQ(met.nodes, 9u);
  EXPECT_NEAR(met.time, 0.5, 1e-12);
  EXPECT_NEAR(met.speed, 10, 1e-12);
  const std::string sphere = "*RIGIDWALL_GEOMETRIC_SPHERE\n0,0,0\n0.,0.,-3.,0.,0.,-2.\n1.\n";
  const Expectation round(shell_sheet(2, 2, 4, 2) + shell_part(2, 1, elastic_steel(2)) + sphere + thrown(2, 10) +
                          ends_at(1));
  ASSERT_TRUE(round.report.expected) << round.refused;
  EXPECT_EQ(round.all().not_looked_at.size(), 1u);
}

TEST(ExpectedContacts, AbsurdVelocitiesAreNoTrouble) {
  for (const std::string speed : {"1e300", "-1e300", "1e-300", "1e38"}) {
    const Expectation said(
        falling_sheet(0, "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.," + speed + "\n0.,0.,0.,0.,0.,1.\n"));
    for (const ExpectedContact& e : said.all().contacts) EXPECT_TRUE(!e.margin || std::isfinite(*e.margin)) << speed;
  }
}

}  // namespace
}  // namespace gapcheck::solver::expected_contacts_test
