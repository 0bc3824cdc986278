// *PART_MOVE and *NODE_TRANSFORM: where nodes stand once everything is read.
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
