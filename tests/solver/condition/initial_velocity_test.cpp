#include <gtest/gtest.h>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::initial_velocity_test {
namespace {

const std::string sheet = plate(2, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.3, 7);

TEST(InitialVelocity, SetWithBoxAndExemptions) {
  const Conditioned result =
      good(sheet +
           "*SET_NODE_LIST\n3\n1,2,4,5\n*SET_NODE_LIST\n4\n2\n*DEFINE_BOX\n8,-1.,5.,-1.,0.5,-1.,1.\n"
           "*INITIAL_VELOCITY\n3,4,8\n1.,2.,3.,4.,5.,6.\n7.,8.,9.,0.,0.,1.\n");
  const State& state = result.structure.state;
  EXPECT_EQ(state.v[0], Vector(1, 2, 3));
  EXPECT_EQ(state.w[0], Vector(4, 5, 6));
  EXPECT_EQ(state.v[1], Vector(7, 8, 9));
  EXPECT_EQ(state.w[1], Vector(0, 0, 1));
  EXPECT_EQ(state.v[2], Vector(0, 0, 0));
  EXPECT_EQ(state.v[3], Vector(0, 0, 0));  // outside the box
}

// A blank first card means all nodes; what comes later, and a node's own row, goes over it.
TEST(InitialVelocity, LaterOverridesEarlier) {
  const Conditioned result =
      good(sheet +
           "*INITIAL_VELOCITY_NODE\n3,0.,0.,9.\n*INITIAL_VELOCITY_GENERATION\n5,3,2.,1.,0.,0.\n0.,1.,0.,0.,0.,4.\n"
           "*SET_NODE_LIST\n5\n3,4\n*INITIAL_VELOCITY\n\n1.,2.,3.\n");
  const State& state = result.structure.state;
  EXPECT_EQ(state.v[0], Vector(1, 2, 3));
  EXPECT_EQ(state.v[2], Vector(0, 0, 9));
  EXPECT_EQ(state.v[3], Vector(1, 0, 0));  // node 4 lies on the axis through (0, 1, 0)
  EXPECT_EQ(state.w[3], Vector(0, 0, 2));
}

// v = V + ω × (x − c) on all nodes of a part.
TEST(InitialVelocity, GenerationTurnsAPart) {
  const Conditioned result = good(sheet + "*INITIAL_VELOCITY_GENERATION\n1,2,3.,0.5,0.,0.\n1.,2.,3.,-999.,1.,2.\n");
  const State& state = result.structure.state;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    const Vector wanted = Vector(0.5, 0, 0) + Vector(3, 0, 0).cross(state.x[i] - Vector(1, 2, 3));
    EXPECT_NEAR((state.v[i] - wanted).norm(), 0, 1e-15);
  }
}

// A rigid motion of the nodes is the body's, whatever the weights are.
TEST(InitialVelocity, RigidBodyTakesTheMotionOfItsNodes) {
  const Conditioned result = good(rigid_box + rigid_material +
                                  "*ELEMENT_MASS\n1,17,5.\n*INITIAL_VELOCITY_GENERATION\n7,2,2.,1.,2.,3.\n"
                                  "4.,5.,6.,0.,1.,0.\n");
  const RigidBody& body = result.structure.rigid[0];
  const Vector spin(0, 2, 0), wanted = Vector(1, 2, 3) + spin.cross(body.center() - Vector(4, 5, 6));
  EXPECT_NEAR((body.velocity() - wanted).norm(), 0, 1e-13);
  EXPECT_NEAR((body.angular_velocity() - spin).norm(), 0, 1e-13);
}

// Momentum over mass: one corner of a box of mass 12 (a lumped eighth each) and a mass of 4.5 on another.
TEST(InitialVelocity, MomentumOfUnequalNodes) {
  const Conditioned result =
      good(rigid_box + rigid_material +
           "*ELEMENT_MASS\n1,17,4.5\n*INITIAL_VELOCITY_NODE\n11,1.,0.,0.\n12,1.,0.,0.\n13,1.,0.,0.\n14,1.,0.,0.\n"
           "15,1.,0.,0.\n16,1.,0.,0.\n17,9.,0.,0.\n18,1.,0.,0.\n");
  const RigidBody& body = result.structure.rigid[0];
  EXPECT_NEAR(body.velocity().x() * body.mass(), 7 * 1.5 + 9 * 6, 1e-12);
  const State& state = result.structure.state;
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR((state.v[i] - body.velocity() - body.angular_velocity().cross(state.x[i] - body.center())).norm(), 0,
                1e-13);
}

// Only two corners have a velocity. About the line between them their own rotations count: the mean by mass, which is
// 1.5 and 4.5 here.
TEST(InitialVelocity, NodesOnALineTurnByTheirOwnRotation) {
  const Conditioned result = good(rigid_box + rigid_material +
                                  "*ELEMENT_MASS\n1,15,3.\n*INITIAL_VELOCITY_NODE\n11,1.,0.,0.,0.,0.,2.\n"
                                  "15,1.,0.,0.,0.,0.,6.\n");
  const RigidBody& body = result.structure.rigid[0];
  const Vector spin(0, 0, (1.5 * 2 + 4.5 * 6) / 6);
  EXPECT_NEAR((body.angular_velocity() - spin).norm(), 0, 1e-13);
  EXPECT_NEAR((body.velocity() - Vector(1, 0, 0) - spin.cross(body.center())).norm(), 0, 1e-12);
}

TEST(InitialVelocity, OfARigidBodyGoesOverAll) {
  const Conditioned result =
      good(rigid_box + rigid_material +
           "*INITIAL_VELOCITY_RIGID_BODY\n7,1.,2.,3.,0.1,0.2,0.3\n*INITIAL_VELOCITY\n0\n9.,9.,9.\n");
  EXPECT_NEAR((result.structure.rigid[0].velocity() - Vector(1, 2, 3)).norm(), 0, 1e-15);
  EXPECT_NEAR((result.structure.rigid[0].angular_velocity() - Vector(0.1, 0.2, 0.3)).norm(), 0, 1e-15);
}

TEST(InitialVelocity, WhatIsMissingIsAFailure) {
  for (const auto& [cards, text] : std::vector<std::pair<std::string, std::string>>{
           {"*INITIAL_VELOCITY\n9\n1.\n", "node set 9"},
           {"*INITIAL_VELOCITY\n0,0,9\n1.\n", "box 9"},
           {"*INITIAL_VELOCITY_NODE\n77,1.\n", "node 77"},
           {"*INITIAL_VELOCITY_NODE\n1,1.,0.,0.,0.,0.,0.,3\n", "local system 3"},
           {"*INITIAL_VELOCITY_GENERATION\n9,2\n0.\n", "part 9"},
           {"*INITIAL_VELOCITY_GENERATION\n0,2,1.\n0.\n", "without an axis"},
           {"*INITIAL_VELOCITY_RIGID_BODY\n1,1.\n", "1 is no rigid part"}}) {
    const Conditioned result = conditioned(sheet + cards);
    ASSERT_FALSE(result.status.ok()) << cards;
    EXPECT_NE(result.status.error().message.find(text), std::string::npos) << result.status.error().message;
  }
}

}  // namespace
}  // namespace gapcheck::solver::initial_velocity_test
