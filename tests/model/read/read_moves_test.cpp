// *PART_MOVE and *NODE_TRANSFORM: where nodes stand once everything is read.
#include <cmath>
#include <fstream>
#include <utility>
#include <vector>

#include "model/read.hpp"

namespace gapcheck::model::read_moves_test {
namespace {

/// Parts 1 (nodes 1 to 4) and 2 (nodes 3 to 6), sets of both.
const std::string mesh = nodes_text(7) + part_text + "*PART\nother\n2,1,1\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,3,4,5,6\n" +
                         "*SET_PART\n8\n1,2\n*SET_NODE\n9\n1,7\n";

Vector at(const Read& read, std::int64_t id) { return read.model.mesh.nodes.x[*read.model.mesh.nodes.lookup.find(id)]; }
Vector before(std::int64_t id) { return static_cast<double>(id) * Vector(1, 10, 100); }

TEST(PartMove, MovesEachNodeOfThePartOnce) {
  const Read read = read_text("*PART_MOVE\n       1             1.0             2.0             3.0\n1,0.5\n" + mesh);
  for (const std::int64_t id : {1, 2, 3, 4}) EXPECT_EQ(at(read, id), before(id) + Vector(1.5, 2, 3)) << id;
  for (const std::int64_t id : {5, 6, 7}) EXPECT_EQ(at(read, id), before(id)) << id;
  EXPECT_EQ(read.text(), "");
}

TEST(PartMove, SetsAndSharedNodes) {
  const Read read = read_text(mesh + "*PART_MOVE\n8,1.,,,,1\n");
  EXPECT_EQ(at(read, 1), before(1) + Vector(1, 0, 0));
  EXPECT_EQ(at(read, 3), before(3) + Vector(2, 0, 0));
  EXPECT_EQ(read.warnings(), 1u) << read.text();
  EXPECT_NE(read.text().find("node 3 and perhaps others belong to several parts"), std::string::npos) << read.text();
}

/// 1 along the local x axis and 2 along the local y axis, in systems that are a quarter turn about z and one about x.
TEST(PartMove, LocalSystems) {
  const std::string nodes = "*NODE\n21,5.,5.,5.\n22,5.,9.,5.\n23,1.,5.,5.\n";
  const std::vector<std::pair<std::string, Vector>> systems{
      {"*DEFINE_COORDINATE_SYSTEM\n3,1.,1.,1.,1.,2.,1.\n0.,1.,1.\n", Vector(-2, 1, 0)},
      {"*DEFINE_COORDINATE_SYSTEM_TITLE\na title, with comma\n3,1.,1.,1.,2.,1.,1.\n1.,1.,3.\n", Vector(1, 0, 2)},
      {"*DEFINE_COORDINATE_VECTOR\n3,0.,3.,0.,-1.,7.,0.\n", Vector(-2, 1, 0)},
      {"*DEFINE_COORDINATE_NODES\n2,1,2,3\n3,21,22,23,1,X\n", Vector(-2, 1, 0)}};
  for (const auto& [system, along] : systems) {
    const Read read = read_text(mesh + nodes + system + "*PART_MOVE\n1,1.,2.,0.,3\n");
    EXPECT_LT((at(read, 1) - before(1) - along).norm(), 1e-13) << system << at(read, 1).transpose();
    EXPECT_EQ(read.text(), "") << system;
    EXPECT_TRUE(read.model.not_moved.empty());
  }
}

/// The system of an include turns with it; its number has the offset of the include.
TEST(PartMove, LocalSystemsOfIncludes) {
  const std::string path = testing::TempDir() + "moves_include.k";
  std::ofstream(path) << "*DEFINE_COORDINATE_VECTOR\n3,1.,0.,0.,0.,1.,0.\n*PART_MOVE\n1,1.,0.,0.,3\n";
  const Read read = read_text(mesh + "*INCLUDE_TRANSFORM\n" + path + "\n,,,,,,40\n\n,,2.\n5\n" +
                              "*DEFINE_TRANSFORMATION\n5\nROTATE,0.,0.,1.,0.,0.,0.,90.\n");
  EXPECT_LT((at(read, 1) - before(1) - Vector(0, 2, 0)).norm(), 1e-13) << at(read, 1).transpose();
  EXPECT_EQ(read.text(), "");
}

TEST(PartMove, SystemsThatAreNotKnown) {
  const std::vector<std::pair<std::string, std::string>> systems{
      {"", "no *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR defines it"},
      {"*DEFINE_COORDINATE_SYSTEM\n3,0.,0.,0.,.1,.2,.3\n.3,.6,.9\n", "its axes do not span a plane"},
      {"*DEFINE_COORDINATE_SYSTEM\n3,0.,0.,0.,1.,0.,0.\n", "its axes do not span a plane"},
      {"*DEFINE_COORDINATE_SYSTEM\n3,0.,0.,0.,1.,0.,0.,8\n0.,1.,0.\n", "given in another system"},
      {"*DEFINE_COORDINATE_SYSTEM\n3,0.,0.,0.,1.,0.,0.\n0.,1.,0.,1\n", "it is not Cartesian"},
      {"*DEFINE_COORDINATE_VECTOR\n3\n", "its axes do not span a plane"},
      {"*DEFINE_COORDINATE_NODES\n3,1,2,3\n", "its axes do not span a plane"},
      {"*DEFINE_COORDINATE_NODES\n3,1,2,99\n", "its node 99 is not defined"},
      {"*DEFINE_COORDINATE_NODES\n3,1,2,3,0,Y\n", "its first axis is Y"},
      {"*DEFINE_COORDINATE_NODES\n3,1,2,3,0,X,2\n", "it is not Cartesian"}};
  for (const auto& [system, why] : systems) {
    const Read read = read_text(mesh + system + "*PART_MOVE\n1,1.,2.,0.,3\n1,0.,0.,1.\n");
    EXPECT_EQ(at(read, 1), before(1) + Vector(0, 0, 1)) << system;
    EXPECT_EQ(read.warnings(), 1u) << system << read.text();
    EXPECT_NE(read.text().find(why), std::string::npos) << read.text();
    ASSERT_EQ(read.model.not_moved.size(), 1u);
    EXPECT_EQ(read.model.not_moved[0].keyword, "PART_MOVE");
  }
}

TEST(PartMove, WhatIsNotDoneIsNamed) {
  const Read read = read_text(mesh + "*PART_MOVE\n1,1.,,,4\n77,1.\n78,1.,,,,1\n");
  EXPECT_EQ(at(read, 1), before(1));
  EXPECT_NE(read.text().find("part 1 is checked where its nodes stand in the deck"), std::string::npos) << read.text();
  EXPECT_NE(read.text().find("names part 77, which is not defined"), std::string::npos) << read.text();
  EXPECT_NE(read.text().find("names part set 78, which is not defined"), std::string::npos) << read.text();
}

TEST(NodeTransform, MovesTheSet) {
  const Read read = read_text("*NODE_TRANSFORM\n5,9\n*DEFINE_TRANSFORMATION\n5\nSCALE,2\nTRANSL,0,0,1\n" + mesh);
  for (const std::int64_t id : {1, 7})
    EXPECT_EQ(at(read, id), Vector(2 * before(id)[0], before(id)[1], before(id)[2] + 1)) << id;
  EXPECT_EQ(at(read, 2), before(2));
  EXPECT_EQ(read.text(), "");
}

TEST(NodeTransform, FaultsAreNamed) {
  const Read read =
      read_text(mesh + "*NODE_TRANSFORM\n6,9\n6,9\n5,10\n5,9\n5,9\n*DEFINE_TRANSFORMATION\n5\nPOS6N,1,2,3,4,5,6\n");
  EXPECT_EQ(at(read, 1), before(1));
  EXPECT_EQ(read.faults(Fault::Kind::unknown_reference), 2u) << read.text();
  EXPECT_EQ(read.errors(), 1u) << read.text();
  EXPECT_NE(read.text().find("transformation 6, which is not defined"), std::string::npos) << read.text();
  EXPECT_NE(read.text().find("node set 10, which is not defined"), std::string::npos) << read.text();
}

/// Ten nodes with the four of a quarter turn about z through (1, 0, 0) among them.
const std::string frame =
    "*NODE\n1,1.,0.,0.\n2,1.,0.,3.\n3,2.,0.,5.\n4,0.,0.,0.\n5,0.,4.,0.\n*SET_NODE\n9\n3\n*SET_NODE\n8\n2,3\n";

TEST(NodeTransform, AQuarterTurnAboutTwoNodes) {
  const Read read = read_text(frame + "*NODE_TRANSFORM\n5,9\n*DEFINE_TRANSFORMATION\n5\nROTATE3NA,1,2,1,90\n");
  EXPECT_LT((at(read, 3) - Vector(1, 1, 5)).norm(), 1e-14) << at(read, 3);
  EXPECT_EQ(read.text(), "");
}

TEST(NodeTransform, ByPointsAndNodes) {
  // From node 1 to node 4, the line to node 2 onto that to node 5, the plane of node 3 onto that of node 2.
  const Read read = read_text(frame + "*NODE_TRANSFORM\n5,8\n*DEFINE_TRANSFORMATION\n5\nPOS6N,1,2,3,4,5,2\n");
  EXPECT_LT((at(read, 2) - Vector(0, 3, 0)).norm(), 1e-14) << at(read, 2);
  EXPECT_NEAR((at(read, 3) - at(read, 2)).norm(), std::sqrt(5.), 1e-14);
  EXPECT_EQ(read.text(), "");
}

/// Without IMMED a transformation takes the original coordinates of its nodes, with IMMED = 1 those at its place.
TEST(NodeTransform, OriginalCoordinatesAndImmediateMoves) {
  const std::string transformations =
      "*DEFINE_TRANSFORMATION\n5\nTRANSL,0.,10.,0.\n*DEFINE_TRANSFORMATION\n6\nTRANSL2ND,4,2,1.\n";
  const Read later = read_text(frame + transformations + "*NODE_TRANSFORM\n5,8\n6,9\n");
  const Vector original = Vector(1, 0, 3).normalized(), moved = Vector(1, 10, 3).normalized();
  EXPECT_LT((at(later, 3) - (Vector(2, 10, 5) + original)).norm(), 1e-14) << at(later, 3);
  const Read now = read_text(frame + transformations + "*NODE_TRANSFORM\n5,8,1\n6,9,1\n");
  EXPECT_LT((at(now, 3) - (Vector(2, 10, 5) + moved)).norm(), 1e-14) << at(now, 3);
  // Immediate ones come before all others, wherever they are.
  const Read mixed = read_text(frame + transformations + "*NODE_TRANSFORM\n6,9\n5,8,1\n");
  EXPECT_LT((at(mixed, 3) - (Vector(2, 10, 5) + moved)).norm(), 1e-14) << at(mixed, 3);
  for (const Read* read : {&later, &now, &mixed}) EXPECT_EQ(read->text(), "");
}

TEST(NodeTransform, ImmediateMovesAndBoxes) {
  const Read read = read_text(frame + "*DEFINE_BOX\n1,0.,1.,0.,1.,0.,1.\n*DEFINE_TRANSFORMATION\n5\nTRANSL,1.\n" +
                              "*NODE_TRANSFORM\n5,9,1\n5,9,1\n");
  EXPECT_EQ(at(read, 3), Vector(4, 0, 5));
  EXPECT_EQ(read.warnings(), 1u) << read.text();
  EXPECT_NE(read.text().find("sets by *DEFINE_BOX are chosen before it moves nodes"), std::string::npos) << read.text();
}

TEST(NodeTransform, FaultyNodesAreNamedOnce) {
  const Read read = read_text(frame + "*NODE_TRANSFORM\n5,9\n5,8\n5,9,1\n5,9,1\n*DEFINE_TRANSFORMATION\n5\n" +
                              "ROTATE3NA,1,77,1,90\n");
  EXPECT_EQ(at(read, 3), Vector(2, 0, 5));
  EXPECT_EQ(read.errors(), 1u) << read.text();
  EXPECT_NE(read.text().find("ROTATE3NA: node 77 is not defined"), std::string::npos) << read.text();
}

TEST(NodeTransform, ImmediateWorkIsBounded) {
  std::string rows;
  for (int i = 0; i < 1500; ++i) rows += "5,4,1\n";
  const Read read =
      read_text(frame + "*SET_NODE\n4\n4\n*NODE\n6\n7\n8\n9\n10\n11\n12\n13\n14\n15\n16\n*NODE_TRANSFORM\n" + rows +
                "*DEFINE_TRANSFORMATION\n5\nTRANSL2ND,4,1,1.\n");
  EXPECT_EQ(read.errors(), 500u);
  EXPECT_NE(read.text().find("more than 1000 rows with IMMED = 1"), std::string::npos);
}

TEST(NodeTransform, WorkIsBounded) {
  std::string rows;
  for (int i = 0; i < 500; ++i) rows += "5,9\n";
  const Read read = read_text(mesh + "*NODE_TRANSFORM\n" + rows + "*DEFINE_TRANSFORMATION\n5\nTRANSL,1\n");
  // A hundred times the nodes of the model, and a hundred more: 400 moves of two nodes each.
  EXPECT_EQ(at(read, 1)[0], before(1)[0] + 400);
  EXPECT_EQ(at(read, 7)[0], before(7)[0] + 400);
  EXPECT_EQ(read.errors(), 100u) << "one for each row that is not done";
}

}  // namespace
}  // namespace gapcheck::model::read_moves_test
