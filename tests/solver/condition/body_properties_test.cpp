#include <gtest/gtest.h>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::body_properties_test {
namespace {

const std::string inertia_part =
    "*NODE\n11,0.,0.,0.\n12,1.,0.,0.\n13,1.,2.,0.\n14,0.,2.,0.\n15,0.,0.,3.\n16,1.,0.,3.\n17,1.,2.,3.\n18,0.,2.,3.\n"
    "*ELEMENT_SOLID\n9,7,11,12,13,14,15,16,17,18\n*SECTION_SOLID\n7,1\n*MAT_RIGID\n7,2.,1000.,0.3\n"
    "*PART_INERTIA\nbox\n7,7,7\n";

TEST(BodyProperties, ConstraintsOfTheMaterial) {
  const Conditioned result = good(rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n1.,4,6\n*INITIAL_VELOCITY\n0\n1.,2.,3.\n");
  EXPECT_EQ(result.structure.rigid.held(0), 1u + 2u + 8u + 32u);
  Conditioned again = good(rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n1.00,4.00,7.00\n*INITIAL_VELOCITY\n0\n1.,2.,3.\n");
  Stepper stepper = std::move(again).stepper(fixed_step(0.25));
  run(stepper, 4);
  EXPECT_EQ(stepper.structure().rigid[0].velocity(), Vector(0, 0, 3));
  // Without CMO the codes mean nothing.
  EXPECT_EQ(good(rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n0.,7,7\n").structure.rigid.held(0), 0u);
  const Conditioned local = conditioned(rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n-1.,3,111111\n");
  ASSERT_FALSE(local.status.ok());
  EXPECT_EQ(local.status.error().kind, Failure::Kind::not_calculated);
}

// The leading part's constraints are those of the merged body.
TEST(BodyProperties, ConstraintsOfMergedParts) {
  const std::string second =
      "*NODE\n21,5.,0.,0.\n22,6.,0.,0.\n23,6.,2.,0.\n24,5.,2.,0.\n25,5.,0.,3.\n26,6.,0.,3.\n27,6.,2.,3.\n28,5.,2.,3.\n"
      "*ELEMENT_SOLID\n10,6,21,22,23,24,25,26,27,28\n*PART\nsecond\n6,7,6\n*MAT_RIGID\n6,2.,1000.,0.3\n1.,7,7\n";
  for (const auto& [merged, held] : {std::pair{"7,6", 1u}, {"6,7", 63u}}) {
    const Conditioned result = good(rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n1.,1,0\n" + second +
                                    "*CONSTRAINED_RIGID_BODIES\n" + merged + "\n");
    ASSERT_EQ(result.structure.rigid.size(), 1u);
    EXPECT_EQ(result.structure.rigid.held(0), held) << merged;
    EXPECT_EQ(result.structure.body_of_id.at(6), 0u);
    EXPECT_EQ(result.structure.body_of_id.at(7), 0u);
  }
}

TEST(BodyProperties, InertiaOfThePart) {
  const Conditioned result = good(inertia_part +
                                  "0.5,1.,2.,5.\n10.,1.,2.,20.,3.,30.\n1.,2.,3.,0.1,0.2,0.3\n"
                                  "*INITIAL_VELOCITY\n0\n9.,9.,9.\n");
  const RigidBody& body = result.structure.rigid[0];
  EXPECT_DOUBLE_EQ(body.mass(), 5);
  EXPECT_NEAR((body.center() - Vector(0.5, 1, 2)).norm(), 0, 1e-15);
  Matrix tensor;
  tensor << 10, 1, 2, 1, 20, 3, 2, 3, 30;
  EXPECT_NEAR((body.inertia() - tensor).norm(), 0, 1e-12);
  EXPECT_NEAR((body.velocity() - Vector(1, 2, 3)).norm(), 0, 1e-15);
  EXPECT_NEAR((body.angular_velocity() - Vector(0.1, 0.2, 0.3)).norm(), 0, 1e-14);
  EXPECT_NE(result.warnings.find("IRIGID = 1"), std::string::npos) << result.warnings;
  EXPECT_NEAR((result.structure.state.v[0] - body.velocity() -
               body.angular_velocity().cross(result.structure.state.x[0] - body.center()))
                  .norm(),
              0, 1e-14);
}

// Nodes of a part that is not there belong to no body.
TEST(BodyProperties, ExtraNodesOfNoPart) {
  const Conditioned result =
      good(rigid_box + rigid_material + point_mass + "*CONSTRAINED_EXTRA_NODES_NODE\n99,1\n*INITIAL_VELOCITY\n0\n1.\n");
  EXPECT_EQ(result.structure.rigid.size(), 1u);
  EXPECT_FALSE(result.structure.rigid.holds(8));
  EXPECT_EQ(result.structure.rigid.nodes(0).size(), 8u);
}

// Local axes: x along global y, y along global z. A mass on a node moves the centre.
TEST(BodyProperties, LocalAxesAndMassesOfNodes) {
  const Conditioned result = good(inertia_part +
                                  "0.,0.,0.,5.,1,17\n10.,0.,0.,20.,0.,30.\n0.,0.,0.\n0.,1.,0.,0.,0.,1.\n"
                                  "*ELEMENT_MASS\n1,11,5.\n*INITIAL_VELOCITY\n0,0,0,1\n9.,9.,9.\n");
  const RigidBody& body = result.structure.rigid[0];
  EXPECT_DOUBLE_EQ(body.mass(), 10);
  EXPECT_NEAR((body.center() - Vector(0.5, 1, 1.5)).norm(), 0, 1e-15);
  const double squared = 0.25 + 1 + 2.25;  // of the distance of both masses from the centre
  EXPECT_NEAR(body.inertia()(0, 0), 30 + 10 * (squared - 0.25), 1e-12);
  EXPECT_NEAR(body.inertia()(1, 1), 10 + 10 * (squared - 1), 1e-12);
  EXPECT_NEAR(body.inertia()(2, 2), 20 + 10 * (squared - 2.25), 1e-12);
  EXPECT_NEAR(body.inertia()(0, 1), -10 * 0.5, 1e-12);
  EXPECT_NEAR((body.velocity() - Vector(9, 9, 9)).norm(), 0, 1e-14);
}

TEST(BodyProperties, NodalRigidBody) {
  const Conditioned result = good(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,2.\n3,3,2.\n*SET_NODE_LIST\n4\n1,2,3\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA\n5,0,4\n1.,3,4\n0.,0.,0.,6.\n1.,0.,0.,1.,0.,1.\n1.,0.,0.\n");
  EXPECT_EQ(result.structure.rigid.held(0), 4u + 8u + 16u);
  EXPECT_DOUBLE_EQ(result.structure.rigid[0].mass(), 12);
  EXPECT_EQ(result.structure.rigid[0].velocity(), Vector(1, 0, 0));
}

TEST(BodyProperties, ContradictionsAreFailures) {
  const auto expect = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Conditioned result = conditioned(deck);
    ASSERT_FALSE(result.status.ok()) << deck;
    EXPECT_EQ(result.status.error().kind, kind);
    EXPECT_NE(result.status.error().message.find(text), std::string::npos) << result.status.error().message;
  };
  expect(rigid_box + rigid_material + "*SET_NODE_LIST\n4\n11,12\n*CONSTRAINED_NODAL_RIGID_BODY\n5,0,4\n",
         Failure::Kind::contradiction, "node 11 belongs to another rigid body");
  expect(inertia_part + "0.,0.,0.,0.\n1.,0.,0.,1.,0.,1.\n0.\n", Failure::Kind::zero_mass, "above zero");
  expect(inertia_part + "0.,0.,0.,1.\n1.,0.,0.,-1.,0.,1.\n0.\n", Failure::Kind::zero_mass, "above zero");
  expect(inertia_part + "0.,0.,0.,1.,0,99\n1.,0.,0.,1.,0.,1.\n0.\n", Failure::Kind::unknown_reference, "node 99");
}

}  // namespace
}  // namespace gapcheck::solver::body_properties_test
