#include "model/entity/weld.hpp"

#include "model/read.hpp"

namespace gapcheck::model::weld_test {
namespace {

TEST(Welds, SpotWeld) {
  const Read read = read_text(nodes_text(5) +
                              "*CONSTRAINED_SPOTWELD\n1,2,10.,20.,2.,3.,0.5,0.1\n3,4\n"
                              "*CONSTRAINED_SPOTWELD_ID\n77\n         4         5\n");
  ASSERT_EQ(read.model.welds.size(), 3u) << read.text();
  EXPECT_EQ(read.text(), "");
  const Weld& weld = read.model.welds[0];
  EXPECT_EQ(weld.id, 1);
  EXPECT_FALSE(weld.generalized);
  ASSERT_EQ(weld.nodes.size(), 2u);
  EXPECT_EQ(weld.nodes[1], NodeIndex{1});
  EXPECT_EQ(weld.normal_force, 10);
  EXPECT_EQ(weld.shear_force, 20);
  EXPECT_EQ(weld.normal_power, 2);
  EXPECT_EQ(weld.shear_power, 3);
  EXPECT_EQ(weld.failure_time, 0.5);
  EXPECT_EQ(weld.plastic_strain, 0.1);
  EXPECT_EQ(weld.place.line, 8u);
  EXPECT_EQ(read.model.file(weld.place), "a.k");
  EXPECT_EQ(read.model.welds[1].id, 2);
  EXPECT_EQ(read.model.welds[1].normal_force, 0);
  EXPECT_EQ(read.model.welds[2].id, 77);
  EXPECT_EQ(read.model.welds[2].nodes[0], NodeIndex{3});
}

TEST(Welds, GeneralizedSpotWeld) {
  const Read read = read_text(nodes_text(5) +
                              "*SET_NODE_LIST\n4\n1,3,5\n*CONSTRAINED_GENERALIZED_WELD_SPOT\n4\n\n"
                              "*CONSTRAINED_GENERALIZED_WELD_SPOT_ID\n9\n4\n0.5,0.,7.,8.,1.,2.\n");
  ASSERT_EQ(read.model.welds.size(), 2u) << read.text();
  EXPECT_EQ(read.text(), "");
  EXPECT_TRUE(read.model.welds[0].generalized);
  EXPECT_EQ(read.model.welds[0].nodes.size(), 3u);
  EXPECT_EQ(read.model.welds[0].failure_time, 0);
  EXPECT_EQ(read.model.welds[1].id, 9);
  EXPECT_EQ(read.model.welds[1].failure_time, 0.5);
  EXPECT_EQ(read.model.welds[1].normal_force, 7);
  EXPECT_EQ(read.model.welds[1].shear_power, 2);
}

TEST(Welds, WhatIsNotThereIsNamed) {
  const Read read = read_text(nodes_text(2) + "*CONSTRAINED_SPOTWELD\n1,9\n*CONSTRAINED_GENERALIZED_WELD_SPOT\n4\n\n");
  EXPECT_TRUE(read.model.welds.empty());
  EXPECT_EQ(read.faults(Fault::Kind::unknown_reference), 2u) << read.text();
  EXPECT_EQ(read.warnings(), 2u);
}

}  // namespace
}  // namespace gapcheck::model::weld_test
