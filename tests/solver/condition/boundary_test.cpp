#include <gtest/gtest.h>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::boundary_test {
namespace {

TEST(Boundary, HoldsFreedomsOfNodesAndSets) {
  const Conditioned plate_held = good(plate(2, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.3, 7) +
                                      "*SET_NODE_LIST\n3\n1,2\n*BOUNDARY_SPC_SET_ID\n1,left\n3,0,1,0,1,0,0,1\n"
                                      "*BOUNDARY_SPC_NODE\n2,0,0,1\n");
  const Constraints& constraints = plate_held.structure.constraints;
  EXPECT_EQ(constraints.mask(0), 1 + 4 + 32);
  EXPECT_EQ(constraints.mask(1), 1 + 2 + 4 + 32);
  EXPECT_EQ(constraints.mask(2), 0);
  EXPECT_EQ(plate_held.warnings, "");
}

TEST(Boundary, CodesOfNodes) {
  const Conditioned held = good(
      "*NODE\n1,0.,0.,0.,7,4\n"
      "       2             1.0             0.0             0.0       6       0\n"
      "       3             1.0             1.0             0.0       0       0\n"
      "       4             0.0             1.0             0.0\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n" +
      elastic_deck(shell_section, 1000, 0.3, 7));
  EXPECT_EQ(held.structure.constraints.mask(0), 7 + 8 + 16);
  EXPECT_EQ(held.structure.constraints.mask(1), 1 + 4);
  EXPECT_EQ(held.structure.constraints.mask(2), 0);
  EXPECT_EQ(held.structure.constraints.mask(3), 0);
}

TEST(Boundary, NodesOfRigidBodiesAreNotHeld) {
  const Conditioned held = good(rigid_box + rigid_material + "*BOUNDARY_SPC_NODE\n11,0,1,1,1\n");
  EXPECT_EQ(held.structure.constraints.mask(0), 0);
  EXPECT_NE(held.warnings.find("1 of the nodes belong to rigid bodies"), std::string::npos) << held.warnings;
}

TEST(Boundary, WhatIsNotCalculatedIsAFailure) {
  const auto expect = [](const std::string& cards, Failure::Kind kind, std::string_view text) {
    const Conditioned result = conditioned(point_mass + cards);
    ASSERT_FALSE(result.status.ok()) << cards;
    EXPECT_EQ(result.status.error().kind, kind) << result.status.error().message;
    EXPECT_NE(result.status.error().message.find(text), std::string::npos) << result.status.error().message;
  };
  expect("*BOUNDARY_SPC_NODE\n1,5,1\n", Failure::Kind::not_calculated, "*BOUNDARY_SPC_NODE: ");
  EXPECT_EQ(conditioned(point_mass + "*BOUNDARY_SPC_NODE\n1,5,1\n").status.error().place.line, 6U);
  expect("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n0.5,2.\n", Failure::Kind::not_calculated, "birth or death");
  expect("*BOUNDARY_SPC_SET\n4,0,1\n", Failure::Kind::unknown_reference, "node set 4");
  expect("*BOUNDARY_SPC_NODE\n4,0,1\n", Failure::Kind::unknown_reference, "node 4");
}

}  // namespace
}  // namespace gapcheck::solver::boundary_test
