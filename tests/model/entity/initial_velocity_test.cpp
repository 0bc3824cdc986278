#include "model/entity/initial_velocity.hpp"

#include "model/read.hpp"

namespace gapcheck::model::initial_velocity_test {
namespace {

using Kind = InitialVelocity::Kind;

TEST(InitialVelocity, SetsWithExemptions) {
  const Read read = read_text(
      "*INITIAL_VELOCITY\n\n"
      "       1.0       2.0       3.0       4.0       5.0       6.0\n"
      "         2         3         4         1         5\n"
      "       7.0\n"
      "       8.0       0.0       0.0       0.0       0.0       9.0\n");
  const auto& all = read.model.initial_velocities;
  ASSERT_EQ(all.size(), 2u) << read.text();
  EXPECT_EQ(all[0].id, 0);
  EXPECT_EQ(all[0].velocity, Vector(1, 2, 3));
  EXPECT_EQ(all[0].spin, Vector(4, 5, 6));
  EXPECT_EQ(all[1].id, 2);
  EXPECT_EQ(all[1].exempted_set, 3);
  EXPECT_EQ(all[1].box, 4);
  EXPECT_EQ(all[1].irigid, 1);
  EXPECT_EQ(all[1].system, 5);
  EXPECT_EQ(all[1].velocity, Vector(7, 0, 0));
  EXPECT_EQ(all[1].exempted_velocity, Vector(8, 0, 0));
  EXPECT_EQ(all[1].exempted_spin, Vector(0, 0, 9));
}

TEST(InitialVelocity, NodesBodiesAndGeneration) {
  const Read read = read_text(
      "*INITIAL_VELOCITY_NODE\n5,1.,2.,3.,4.,5.,6.,7\n\n6,1.\n"
      "*INITIAL_VELOCITY_RIGID_BODY\n8,1.,2.,3.,4.,5.,6.\n"
      "*INITIAL_VELOCITY_GENERATION\n9,2,6.,1.,2.,3.\n4.,5.,6.,0.,2.,0.,1,1\n9,3,6.\n0.,0.,0.,-999.,11.,12.\n");
  ASSERT_EQ(read.model.node_velocities.size(), 2u) << read.text();
  EXPECT_EQ(read.model.node_velocities[0].node, 5);
  EXPECT_EQ(read.model.node_velocities[0].system, 7);
  EXPECT_EQ(read.model.node_velocities[0].spin, Vector(4, 5, 6));
  const auto& all = read.model.initial_velocities;
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].kind, Kind::rigid_body);
  EXPECT_EQ(all[0].id, 8);
  EXPECT_EQ(all[0].velocity, Vector(1, 2, 3));
  EXPECT_EQ(all[1].kind, Kind::generation);
  EXPECT_EQ(all[1].target, 2);
  EXPECT_EQ(all[1].spin, Vector(0, 6, 0));
  EXPECT_EQ(all[1].origin, Vector(4, 5, 6));
  EXPECT_EQ(all[1].phase, 1);
  EXPECT_EQ(all[1].irigid, 1);
  EXPECT_EQ(all[2].axis_nodes[0], 11);
  EXPECT_EQ(all[2].axis_nodes[1], 12);
  EXPECT_EQ(all[2].rate, 6);
}

}  // namespace
}  // namespace gapcheck::model::initial_velocity_test
