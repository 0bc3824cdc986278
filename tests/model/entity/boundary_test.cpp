#include "model/entity/boundary.hpp"

#include <fstream>

#include "model/read.hpp"

namespace gapcheck::model::boundary_test {
namespace {

TEST(Boundary, CodesOfFreedoms) {
  EXPECT_EQ(freedoms_of_code(1), 1);
  EXPECT_EQ(freedoms_of_code(4), 3);
  EXPECT_EQ(freedoms_of_code(5), 6);
  EXPECT_EQ(freedoms_of_code(6), 5);
  EXPECT_EQ(freedoms_of_code(7), 7);
  EXPECT_EQ(freedoms_of_code(-1), 0);
  EXPECT_EQ(freedoms_of_code(8), 0);
}

TEST(Boundary, SinglePointConstraints) {
  const Read read = read_text(
      "*BOUNDARY_SPC_SET\n"
      "         3         7         1         0         1         0         1         1\n\n"
      "         4         0         1\n"
      "*BOUNDARY_SPC_NODE_BIRTH_DEATH_ID\n"
      "        11first\n"
      "        21         0         0         1         0         0         0         0\n"
      "       0.5       0.0\n"
      "        12second\n"
      "        22         0         0         1         0         0         0         0\n"
      "       0.0       2.0\n");
  const auto& spcs = read.model.spcs;
  ASSERT_EQ(spcs.size(), 4u) << read.text();
  EXPECT_EQ(read.text(), "");
  EXPECT_TRUE(spcs[0].nodes.set);
  EXPECT_EQ(spcs[0].nodes.id, 3);
  EXPECT_EQ(spcs[0].system, 7);
  EXPECT_EQ(spcs[0].freedoms, 1 + 4 + 16 + 32);
  EXPECT_EQ(spcs[1].nodes.id, 4);
  EXPECT_TRUE(spcs[1].lifetime.always());
  EXPECT_FALSE(spcs[2].nodes.set);
  EXPECT_EQ(spcs[2].nodes.id, 21);
  EXPECT_EQ(spcs[2].lifetime.birth, 0.5);
  EXPECT_EQ(spcs[3].nodes.id, 22);
  EXPECT_EQ(spcs[3].lifetime.death, 2);
  EXPECT_EQ(read.model.where(spcs[3].place), "line 10 of a.k");
}

TEST(Boundary, CodesOfNodesInAllFormats) {
  const Read read = read_text(
      "*NODE\n"
      "       1             0.0             0.0             0.0       1       0\n"
      "$      9             0.0             0.0             0.0       7       7\n"
      "       2             0.0             0.0             0.0       0       0\n"
      "       3             0.0             0.0             0.0       1       0\n"
      "4,0.,0.,0.,0,5\n"
      "*NODE%\n"
      "         5             0.0             0.0             0.0         7         7\n"
      "*NODE+\n"
      "                   6                 0.0                 0.0                 0.0                   2\n");
  const auto& constraints = read.model.node_constraints;
  ASSERT_EQ(constraints.size(), 4u) << read.text();
  EXPECT_EQ(constraints[0].freedoms, 1);
  EXPECT_EQ(constraints[0].nodes, (std::vector<NodeIndex>{NodeIndex{0}, NodeIndex{2}}));
  EXPECT_EQ(constraints[1].freedoms, 6 << 3);
  EXPECT_EQ(constraints[2].freedoms, 63);
  EXPECT_EQ(constraints[3].freedoms, 2);
  EXPECT_EQ(constraints[3].nodes, (std::vector<NodeIndex>{NodeIndex{5}}));
}

TEST(Boundary, PrescribedMotions) {
  const Read read = read_text(
      "*BOUNDARY_PRESCRIBED_MOTION_SET_ID\n"
      "         1a motion\n"
      "         5         3         2        11       2.5         0       4.0       1.0\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,5,0,12\n7,9,0,12\n1.,2.,3\n7,-4,1,13,2.,8\n"
      "*DEFINE_VECTOR\n8,1.,1.,1.,1.,4.,1.\n");
  const auto& motions = read.model.prescribed_motions;
  ASSERT_EQ(motions.size(), 4u) << read.text();
  EXPECT_EQ(motions[0].nodes.id, 5);
  EXPECT_TRUE(motions[0].nodes.set);
  EXPECT_EQ(motions[0].freedom, 3);
  EXPECT_EQ(motions[0].quantity, 2);
  EXPECT_EQ(motions[0].curve, 11);
  EXPECT_EQ(motions[0].scale, 2.5);
  EXPECT_EQ(motions[0].lifetime.birth, 1);
  EXPECT_EQ(motions[0].lifetime.death, 4);
  EXPECT_TRUE(motions[1].rigid);
  EXPECT_EQ(motions[1].part, 7);
  EXPECT_EQ(motions[1].scale, 1);
  EXPECT_EQ(motions[2].freedom, 9);
  EXPECT_EQ(motions[3].freedom, -4);
  EXPECT_EQ(motions[3].vector, 8);
  EXPECT_EQ(read.model.vectors.at(8).direction, Vector(0, 3, 0));
}

// Millimetres and milliseconds come as metres and seconds; ids move by kind.
TEST(Boundary, IncludesChangeUnitsAndIds) {
  const std::string path = testing::TempDir() + "boundary_include.k";
  std::ofstream(path) << "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,1,0,12,3.,0,20.,10.\n7,5,1,12\n7,2,2,12,4.\n"
                         "*BOUNDARY_SPC_SET\n4,0,1\n*BOUNDARY_SPC_NODE\n4,0,1\n"
                         "*INITIAL_VELOCITY_NODE\n5,2.,0.,0.,3.\n";
  const Read read = read_text("*DEFINE_TRANSFORMATION\n3\nROTATE,0.,0.,1.,0.,0.,0.,90.\n*INCLUDE_TRANSFORM\n" + path +
                              "\n100,,1000,,10000,100000\n,,\n0.001,0.001,0.001\n3\n");
  EXPECT_EQ(read.errors(), 0u) << read.text();
  ASSERT_EQ(read.model.prescribed_motions.size(), 3u);
  const PrescribedMotion& motion = read.model.prescribed_motions[0];
  EXPECT_EQ(motion.part, 1007);
  EXPECT_EQ(motion.curve, 100012);
  EXPECT_DOUBLE_EQ(motion.scale, 3);
  EXPECT_DOUBLE_EQ(motion.lifetime.birth, 0.01);
  EXPECT_DOUBLE_EQ(motion.lifetime.death, 0.02);
  EXPECT_DOUBLE_EQ(read.model.prescribed_motions[1].turn_scale, 1e6);
  EXPECT_DOUBLE_EQ(read.model.prescribed_motions[1].scale, 1e3);
  EXPECT_DOUBLE_EQ(read.model.prescribed_motions[2].turn_scale, 4);  // a displacement has no time in it
  EXPECT_DOUBLE_EQ(read.model.prescribed_motions[2].scale, 0.004);
  ASSERT_EQ(read.model.spcs.size(), 2u);
  EXPECT_EQ(read.model.spcs[0].nodes.id, 10004);
  EXPECT_EQ(read.model.spcs[1].nodes.id, 104);
  ASSERT_EQ(read.model.node_velocities.size(), 1u);
  EXPECT_EQ(read.model.node_velocities[0].node, 105);
  EXPECT_NEAR((read.model.node_velocities[0].velocity - Vector(0, 2, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((read.model.node_velocities[0].spin - Vector(0, 3000, 0)).norm(), 0, 1e-9);
}

}  // namespace
}  // namespace gapcheck::model::boundary_test
