#include "model/entity/rigid_wall.hpp"

#include "model/read.hpp"
#include "model/read/node_references.hpp"

namespace gapcheck::model::rigid_wall_test {
namespace {

using Shape = RigidWall::Shape;

TEST(RigidWalls, PlanarWithAllItsCards) {
  const Read read = read_text(
      "*RIGIDWALL_PLANAR_ORTHO_FINITE_MOVING_FORCES_ID\n"
      "        12front wall\n"
      "         1         2         3       0.5       0.0       9.0\n"
      "       1.0       2.0       3.0       1.0       2.0       8.0\n"
      "       0.1       0.1       0.1       0.1       0.0       0.0\n"
      "         0         0       1.0       0.0       0.0\n"
      "       4.0       2.0       7.0      10.0      20.0\n"
      "       5.0       1.0\n"
      "         0         0\n"
      "        13\n"
      "\n"
      "       0.0       0.0       0.0       2.0       0.0       0.0\n"
      "\n\n"
      "       0.0       1.0       0.0       0.0       0.0\n"
      "\n\n");
  ASSERT_EQ(read.model.rigid_walls.size(), 2u) << read.text();
  const RigidWall& wall = read.model.rigid_walls[0];
  EXPECT_EQ(wall.id, 12);
  EXPECT_EQ(wall.title, "front wall");
  EXPECT_EQ(wall.node_set, 1);
  EXPECT_EQ(wall.exempted_set, 2);
  EXPECT_EQ(wall.box, 3);
  EXPECT_EQ(wall.offset, 0.5);
  EXPECT_EQ(wall.tail, Vector(1, 2, 3));
  EXPECT_EQ(wall.normal, Vector(0, 0, 1));
  EXPECT_EQ(wall.edge_l, Vector(1, 0, 0));  // the part along the normal does not count
  EXPECT_EQ(wall.edge_m, Vector(0, 1, 0));
  EXPECT_EQ(wall.length_l, 10);
  EXPECT_EQ(wall.length_m, 20);
  EXPECT_EQ(read.model.rigid_walls[1].id, 13);
  EXPECT_EQ(read.model.rigid_walls[1].normal, Vector(1, 0, 0));
  EXPECT_EQ(read.model.rigid_walls[1].length_l, RigidWall::infinite);
}

TEST(RigidWalls, GeometricShapes) {
  const Read read = read_text(
      "*RIGIDWALL_GEOMETRIC_FLAT\n0\n0,0,0,0,0,5\n1,0,0,7,8\n"
      "*RIGIDWALL_GEOMETRIC_PRISM_MOTION\n0\n0,0,0,0,0,5\n1,0,0,7,8,9\n1,0,1.,0.,0.\n"
      "*RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY\n4,0,0,2.5\n0,0,0,0,5,0\n3,11,2\n1,1\n1,1\n1,1.,1.,0.3\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR_ID\n8,ball\n0\n1,2,3\n6\n");
  ASSERT_EQ(read.model.rigid_walls.size(), 4u) << read.text();
  EXPECT_EQ(read.text(), "");
  const auto& walls = read.model.rigid_walls;
  EXPECT_EQ(walls[0].shape, Shape::plane);
  EXPECT_EQ(walls[0].length_m, 8);
  EXPECT_EQ(walls[1].shape, Shape::prism);
  EXPECT_EQ(walls[1].length_p, 9);
  EXPECT_EQ(walls[2].shape, Shape::cylinder);
  EXPECT_EQ(walls[2].id, 3);
  EXPECT_EQ(walls[2].radius, 3);
  EXPECT_EQ(walls[2].length_l, 11);
  EXPECT_EQ(walls[2].birth, 2.5);
  EXPECT_EQ(walls[3].shape, Shape::sphere);
  EXPECT_EQ(walls[3].id, 8);
  EXPECT_EQ(walls[3].tail, Vector(1, 2, 3));
  EXPECT_TRUE(walls[3].interior);
}

TEST(RigidWalls, FrictionTimesAndOptions) {
  const Read read = read_text(
      "*RIGIDWALL_PLANAR_MOVING_FORCES\n0,0,0,0.,0.5,2.5\n0,0,0,0,0,5,0.25\n9.,1.\n7\n"
      "*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,0,0,0,5\n\n\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0,0,0,0.5,2.5\n1,2,3,0,0,0,1.\n6\n3,0,1.,0.,0.\n");
  ASSERT_EQ(read.model.rigid_walls.size(), 3u) << read.text();
  const auto& walls = read.model.rigid_walls;
  EXPECT_EQ(walls[0].keyword, "RIGIDWALL_PLANAR_MOVING_FORCES");
  EXPECT_EQ(walls[0].friction, 0.25);
  EXPECT_TRUE(walls[0].moving);
  EXPECT_EQ(walls[0].soft, 7);
  EXPECT_EQ(walls[0].birth, 0.5);
  EXPECT_EQ(walls[0].death, 2.5);
  EXPECT_TRUE(walls[1].orthotropic);
  EXPECT_FALSE(walls[1].moving);
  EXPECT_TRUE(walls[2].moving);
  EXPECT_EQ(walls[2].death, 2.5);
  EXPECT_EQ(walls[2].friction, 1);
}

TEST(RigidWalls, MotionAndFrictionByDirection) {
  const Read read = read_text(
      "*RIGIDWALL_PLANAR_FINITE_MOVING_FORCES\n0,0,0,0.,0.5,2.5,3.\n0,0,0,0,0,5,2.,7.\n1,0,0,2,3\n9.,1.5\n7\n"
      "*RIGIDWALL_PLANAR_ORTHO_FINITE\n0\n0,0,0,0,0,5\n0.4,0.3,0.2,0.1,5.,6.\n8,9,1.,2.,0.\n1,0,0,2,3\n"
      "*RIGIDWALL_GEOMETRIC_CYLINDER_MOTION\n0,0,0,0.5,2.5\n1,2,3,0,0,0,1.\n6,1.,1\n1,1.\n3,1,1.,2.,0.\n");
  ASSERT_EQ(read.model.rigid_walls.size(), 3u) << read.text();
  const auto& walls = read.model.rigid_walls;
  EXPECT_EQ(walls[0].mass, 9);
  EXPECT_EQ(walls[0].velocity, 1.5);
  EXPECT_EQ(walls[0].weld_velocity, 7);
  EXPECT_EQ(walls[0].stiffness_scale, 3);
  EXPECT_EQ(walls[0].length_m, 3);
  EXPECT_EQ(walls[0].soft, 7);
  const OrthotropicFriction& ortho = walls[1].ortho;
  EXPECT_EQ(
      (std::array{ortho.static_a, ortho.static_b, ortho.dynamic_a, ortho.dynamic_b, ortho.decay_a, ortho.decay_b}),
      (std::array{0.4, 0.3, 0.2, 0.1, 5., 6.}));
  EXPECT_EQ(ortho.node_1, 8);
  EXPECT_EQ(ortho.node_2, 9);
  EXPECT_EQ(ortho.direction, Vector(1, 2, 0));
  EXPECT_EQ(walls[1].length_l, 2);
  EXPECT_EQ(walls[1].stiffness_scale, 1);
  EXPECT_EQ(walls[2].motion_curve, 3);
  EXPECT_EQ(walls[2].motion_option, 1);
  EXPECT_EQ(walls[2].motion_direction, Vector(1, 2, 0));
}

TEST(RigidWalls, WhatIsNoShapeIsAnErrorAndLeftOut) {
  const Read read = read_text(
      "*RIGIDWALL_PLANAR\n0\n1,2,3,1,2,3\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE\n0\n1,2,3\n0\n"
      "*RIGIDWALL_GEOMETRIC_FLAT\n0\n0,0,0,0,0,5\n0,0,9,7,8\n"
      "*RIGIDWALL_PLANAR\n0\n"
      "*RIGIDWALL_FORCE_TRANSDUCER\n1\n1,0,1\n");
  EXPECT_TRUE(read.model.rigid_walls.empty());
  EXPECT_EQ(read.errors(), 4u) << read.text();
}

TEST(NodeReferences, FieldsOfKnownKeywordsAndRowsOfConstraints) {
  const Read read = read_text(nodes_text(9));
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(
      "*BOUNDARY_SPC_NODE\n2,0,1\n*CONSTRAINED_JOINT_REVOLUTE_ID\n1,no number\n4,5\n*DEFINE_CURVE\n7\n7.,7.\n", "b.k",
      {}, diagnostics);
  ASSERT_TRUE(deck);
  const auto used = referenced_nodes(deck.value(), read.model, "");
  EXPECT_EQ(used[1], 1);
  EXPECT_EQ(used[3], 1);
  EXPECT_EQ(used[4], 1);
  EXPECT_EQ(used[6], 0);
  const auto constrained = referenced_nodes(deck.value(), read.model, "CONSTRAINED_");
  EXPECT_EQ(constrained[1], 0);
  EXPECT_EQ(constrained[3], 1);
}

}  // namespace
}  // namespace gapcheck::model::rigid_wall_test
