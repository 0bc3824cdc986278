#include "model/entity/sets.hpp"

#include <fstream>
#include <random>
#include <set>

#include "model/read.hpp"

namespace gapcheck::model::sets_test {
namespace {

using Ids = std::vector<std::int64_t>;

Ids node_ids(const Model& model, std::int64_t set) {
  Ids ids;
  for (const NodeIndex node : model.sets.nodes.at(set).members) ids.push_back(model.mesh.nodes.id[node.value]);
  return ids;
}
Ids part_ids(const Model& model, std::int64_t set) {
  Ids ids;
  for (const PartIndex part : model.sets.parts.at(set).members) ids.push_back(model.part(part).id.value);
  return ids;
}
Ids shell_ids(const Model& model, std::int64_t set) {
  Ids ids;
  for (const std::uint32_t shell : model.sets.shells.at(set).members) ids.push_back(model.mesh.shells.id[shell]);
  return ids;
}
std::vector<Ids> segment_ids(const Model& model, std::int64_t set) {
  std::vector<Ids> result;
  for (const SegmentNodes& segment : model.sets.segments.at(set).members) {
    Ids ids;
    for (const NodeIndex node : segment) ids.push_back(model.mesh.nodes.id[node.value]);
    result.push_back(ids);
  }
  return result;
}

TEST(Sets, ListsWithTitleDefaultsAndRepetition) {
  const Read read = read_text(nodes_text(9) +
                              "*SET_NODE_LIST_TITLE\nsome, nodes\n         5       0.1       0.2\n"
                              "         3         1         2         3         0         9\n7,8\n"
                              "*SET_NODE\n6\n4\n*SET_NODE_COLUMN\n7\n1,0.5\n2,0.5\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(node_ids(read.model, 5), (Ids{3, 1, 2, 9, 7, 8}));
  EXPECT_EQ(read.model.sets.nodes.at(5).title, "some, nodes");
  EXPECT_EQ(read.model.sets.nodes.at(5).defaults, (std::array<double, 4>{0.1, 0.2, 0, 0}));
  EXPECT_EQ(read.model.sets.nodes.at(5).place.line, 13u);
  EXPECT_EQ(node_ids(read.model, 6), (Ids{4}));
  EXPECT_EQ(node_ids(read.model, 7), (Ids{1, 2}));
}

TEST(Sets, RangesTakeWhatIsThere) {
  const Read read = read_text(nodes_text(9) +
                              "*SET_NODE_LIST_GENERATE\n1\n7,9000000000000000000,1,2\n"
                              "*SET_NODE_LIST_GENERATE_INCREMENT\n2\n2,9,3\n-5,3,0\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(node_ids(read.model, 1), (Ids{7, 8, 9, 1, 2}));
  EXPECT_EQ(node_ids(read.model, 2), (Ids{2, 5, 8, 1, 3}));
}

TEST(Sets, RangesOfPartsAndElements) {
  std::string parts, shells = "*ELEMENT_SHELL\n";
  for (const int id : {9, 3, 7, 5}) {
    parts += "*PART\na\n" + std::to_string(id) + ",1,1\n";
    shells += std::to_string(10 * id) + ",3,1,2,3,4\n";
  }
  const Read read = read_text(nodes_text(4) + part_text + parts + shells +
                              "*SET_PART_LIST_GENERATE\n1\n4,8\n*SET_PART_LIST_GENERATE\n2\n6,6,9,20\n"
                              "*SET_PART_LIST_GENERATE_INCREMENT\n3\n1,9,4\n"
                              "*SET_SHELL_LIST_GENERATE\n4\n50,89\n*SET_SHELL_LIST_GENERATE\n5\n1,1000\n");
  EXPECT_EQ(part_ids(read.model, 1), (Ids{5, 7}));
  EXPECT_EQ(part_ids(read.model, 2), (Ids{9}));
  EXPECT_EQ(part_ids(read.model, 3), (Ids{1, 5, 9}));
  EXPECT_EQ(shell_ids(read.model, 4), (Ids{50, 70}));
  EXPECT_EQ(shell_ids(read.model, 5), (Ids{30, 50, 70, 90}));
}

TEST(Sets, SetsOfSets) {
  const Read read = read_text(nodes_text(9) +
                              "*SET_NODE_ADD\n10\n1,2\n*SET_NODE_LIST\n1\n1,2,3\n*SET_NODE_LIST\n2\n3,4\n"
                              "*SET_NODE_INTERSECT\n11\n1,2\n*SET_NODE_ADD\n12\n10,11\n*SET_NODE_ADD\n13\n1,-11\n"
                              "*SET_NODE_LIST_COLLECT\n20\n5\n*SET_NODE_LIST_COLLECT\n20\n6\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(node_ids(read.model, 10), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(node_ids(read.model, 11), (Ids{3}));
  EXPECT_EQ(node_ids(read.model, 12), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(node_ids(read.model, 13), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(node_ids(read.model, 20), (Ids{5, 6}));
}

TEST(Sets, CyclesEnd) {
  const Read read = read_text(
      nodes_text(3) + "*SET_NODE_ADD\n1\n2,3\n*SET_NODE_ADD\n2\n1\n*SET_NODE_LIST\n3\n1\n*SET_NODE_ADD\n4\n4\n");
  EXPECT_EQ(node_ids(read.model, 1), (Ids{1}));
  EXPECT_EQ(read.errors(), 2u) << read.text();
  EXPECT_TRUE(read.model.faults.empty()) << read.text();
}

TEST(Sets, DeepNestingIsBounded) {
  std::string text = nodes_text(1);
  for (int i = 1; i < 5000; ++i) text += "*SET_NODE_ADD\n" + std::to_string(i) + "\n" + std::to_string(i + 1) + "\n";
  text += "*SET_NODE_LIST\n5000\n1\n";
  const Read read = read_text(text);
  // The outermost set and 100 below it; the one below these is empty, and the next one starts anew.
  EXPECT_EQ(read.errors(), 5000u / 102);
  EXPECT_NE(read.text().find("node set 102 is nested more than 100 deep; it is taken as empty"), std::string::npos)
      << read.text();
  EXPECT_EQ(read.model.sets.nodes.size(), 5000u);
  EXPECT_EQ(node_ids(read.model, 4999), (Ids{1})) << "the innermost sets are whole";
}

Ids branch_parts(const Model& model, std::int64_t branch) {
  Ids ids;
  for (const PartIndex part : model.sets.branches.at(branch).members) ids.push_back(model.part(part).id.value);
  return ids;
}

/// *SET_PART_TREE: positive components are branches, negative ones parts. Branches are no part sets.
TEST(Sets, Branches) {
  const std::string parts =
      "*PART\na\n1,1,1\nb\n2,1,1\nc\n3,1,1\nd\n4,1,1\n*SECTION_SHELL\n1,2\n.1\n*MAT_ELASTIC\n1,1.\n";
  const Read read =
      read_text(parts +
                "*SET_PART_TREE\n7\nthe body, all of it\n8,-2\n,9\n*SET_PART_TREE_TITLE\nx\n8\ndoors\n-4\n"
                "*SET_PART_TREE\n9\n\n-1,-2\n*SET_PART_LIST\n7\n3\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(branch_parts(read.model, 7), (Ids{2, 4, 1}));
  EXPECT_EQ(read.model.sets.branches.at(7).title, "the body, all of it");
  EXPECT_EQ(branch_parts(read.model, 8), (Ids{4}));
  EXPECT_EQ(branch_parts(read.model, 9), (Ids{1, 2}));
  EXPECT_EQ(part_ids(read.model, 7), (Ids{3}));
  // What refers to nothing or to itself.
  const Read hostile =
      read_text(parts +
                "*SET_PART_TREE\n1\nx\n-1,-9,5,2\n*SET_PART_TREE\n2\ny\n1,-2\n*SET_PART_TREE\n2\n\n-3\n"
                "*SET_PART_TREE\n-3\nz\n-1\n*SET_PART_TREE\n*SET_PART_TREE\n4\n"
                "*SET_PART_TREE\n6\nx\n-9223372036854775808,9223372036854775807\n");
  EXPECT_EQ(branch_parts(hostile.model, 1), (Ids{1, 2}));
  EXPECT_TRUE(branch_parts(hostile.model, 4).empty());
  const std::string said = hostile.text();
  for (const char* part :
       {"branch 1 names 2 members that are not defined (9, 5)", "branch 1 contains itself", "branch 2 is defined again",
        "branch id -3 is not positive", "ends before the card with the branch's id",
        "branch 6 names 2 members that are not defined"})
    EXPECT_NE(said.find(part), std::string::npos) << part << " in\n" << said;
  const Read unreadable = read_text(parts + "*SET_PART_TREE\nabc\nx\n-1,def\n*SET_PART_TREE\n7\n\n-1,1e30\n");
  EXPECT_EQ(unreadable.errors(), 2u) << unreadable.text();
  EXPECT_NE(unreadable.text().find("a.k:16: *SET_PART_TREE, field id1: "), std::string::npos) << unreadable.text();
  EXPECT_EQ(branch_parts(unreadable.model, 7), (Ids{1}));
  std::string deep = parts;
  for (int i = 1; i < 300; ++i) deep += "*SET_PART_TREE\n" + std::to_string(i) + "\n\n" + std::to_string(i + 1) + "\n";
  EXPECT_NE(read_text(deep + "*SET_PART_TREE\n300\n\n-1\n").text().find("branch 102 is nested more than 100 deep"),
            std::string::npos);
}

/// Their numbers have the offset of sets, those of parts that of parts.
TEST(Sets, BranchesOfIncludes) {
  const std::string path = testing::TempDir() + "branch_include.k";
  std::ofstream(path) << "*SET_PART_TREE\n7\nx\n8,-2\n*SET_PART_TREE\n8\n\n-1\n";
  const Read read =
      read_text("*PART\na\n101,1,1\nb\n102,1,1\n*SECTION_SHELL\n1,2\n.1\n*MAT_ELASTIC\n1,1.\n*INCLUDE_TRANSFORM\n" +
                path + "\n,,100,,1000\n\n\n\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(branch_parts(read.model, 1007), (Ids{102, 101}));
}

TEST(Sets, GeneralNodesPartsAndShells) {
  const Read read = read_text(nodes_text(12) + part_text +
                              "*PART\nb\n2,1,1\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n3,2,7,8,9\n"
                              "*DEFINE_BOX\n1,0.,4.5,0.,1000.,0.,10000.\n"
                              "*SET_NODE_GENERAL\n1\nPART,2\nDNODE,6,9\n"
                              "*SET_NODE_GENERAL\n2\nALL\nDBOX,1\nDPART,2\nNODE,1\n"
                              "*SET_PART_GENERAL\n3\nALL\nDPART,1\n*SET_PART_LIST\n4\n1\n"
                              "*SET_SHELL_GENERAL\n5\nPART,2\nELEM,1\nDELEM,3\n"
                              "*SET_NODE_GENERAL\n6\nSET_SHELL,5\n"
                              "*SET_SHELL_GENERAL\n7\nBOX,1\n*SET_NODE_GENERAL\n8\nNODE,1,2,3,4,5,6,7\n,8,9\n"
                              "*SET_PART_GENERAL\n9\nBOX,1\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(node_ids(read.model, 1), (Ids{5, 7, 8}));
  EXPECT_EQ(node_ids(read.model, 2), (Ids{10, 11, 12, 1}));
  EXPECT_EQ(part_ids(read.model, 3), (Ids{2}));
  EXPECT_EQ(part_ids(read.model, 4), (Ids{1}));
  EXPECT_EQ(shell_ids(read.model, 5), (Ids{2, 1}));
  EXPECT_EQ(node_ids(read.model, 6), (Ids{5, 6, 7, 8, 1, 2, 3, 4}));
  EXPECT_EQ(shell_ids(read.model, 7), (Ids{1}));
  EXPECT_EQ(node_ids(read.model, 8), (Ids{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(part_ids(read.model, 9), (Ids{1}));
}

TEST(Sets, Segments) {
  const Read read =
      read_text(nodes_text(12) + part_text +
                "*ELEMENT_SHELL\n1,1,1,2,3,4\n"
                "*SET_SEGMENT\n1\n         1         2         3         4       0.5\n5,6,7\n5,6,7,7\n1,2,3,4\n"
                "*SET_SEGMENT_GENERAL\n2\nSEG,1,2,3,0\nPART,1\n"
                "*SET_SEGMENT_ADD\n3\n1,2\n"
                "*SET_NODE_ADD_ADVANCED\n4\n2,5,1,2\n*SET_SHELL_LIST\n1\n1\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(segment_ids(read.model, 1), (std::vector<Ids>{{1, 2, 3, 4}, {5, 6, 7, 7}}));
  EXPECT_EQ(segment_ids(read.model, 2), (std::vector<Ids>{{1, 2, 3, 3}, {1, 2, 3, 4}}));
  EXPECT_EQ(segment_ids(read.model, 3), (std::vector<Ids>{{1, 2, 3, 4}, {5, 6, 7, 7}, {1, 2, 3, 3}}));
  EXPECT_EQ(node_ids(read.model, 4), (Ids{1, 2, 3, 4}));
}

TEST(Sets, SegmentsOfElementSets) {
  const Read read = read_text(nodes_text(12) + part_text +
                              "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7\n*ELEMENT_SOLID\n4,1,1,2,3,4,5,6,7,8\n"
                              "*ELEMENT_BEAM\n5,1,1,2\n"
                              "*SET_SHELL_LIST\n1\n1,2\n*SET_SOLID\n1\n4\n*SET_BEAM\n1\n5\n"
                              "*SET_SEGMENT_GENERAL\n2\nSET_SHELL,1\n*SET_SEGMENT_GENERAL\n3\nSET_SOLID,1\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(segment_ids(read.model, 2), (std::vector<Ids>{{1, 2, 3, 4}, {5, 6, 7, 7}}));
  EXPECT_EQ(segment_ids(read.model, 3).size(), 6u);
  const Read beams = read_text(nodes_text(2) + part_text +
                               "*ELEMENT_BEAM\n5,1,1,2\n*SET_BEAM\n1\n5\n*SET_SEGMENT_GENERAL\n2\nSET_BEAM,1\n");
  EXPECT_EQ(beams.warnings(), 1u) << beams.text();
  EXPECT_TRUE(beams.model.sets.segments.at(2).members.empty());
}

TEST(Sets, ABoxAroundEverythingHoldsEveryNodeOnce) {
  for (const int count : {1, 2, 8, 64, 100}) {
    const Read read =
        read_text(nodes_text(count) + "*DEFINE_BOX\n1,-1e29,1e29,-1e29,1e29,-1e29,1e29\n*SET_NODE_GENERAL\n1\nBOX,1\n");
    ASSERT_EQ(read.model.sets.nodes.at(1).members.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) EXPECT_EQ(node_ids(read.model, 1)[static_cast<std::size_t>(i)], i + 1);
  }
}

TEST(Sets, ElementKinds) {
  const Read read =
      read_text(nodes_text(12) + part_text +
                "*ELEMENT_SOLID\n4,1,1,2,3,4,5,6,7,8\n*ELEMENT_BEAM\n5,1,1,2\n*ELEMENT_DISCRETE\n6,1,1,2\n"
                "*ELEMENT_TSHELL\n7,1,1,2,3,4,5,6,7,8\n"
                "*SET_SOLID\n1,MECH\n4\n*SET_BEAM_GENERATE\n1\n1,9\n*SET_DISCRETE\n1\n6\n*SET_TSHELL\n1\n7\n"
                "*SET_SOLID_GENERAL\n2\nPART,1\n");
  EXPECT_EQ(read.errors(), 0u) << read.text();
  EXPECT_EQ(read.model.sets.solids.at(1).members, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(read.model.sets.solids.at(2).members, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(read.model.sets.beams.at(1).members, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(read.model.sets.discrete.at(1).members, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(read.model.sets.thick_shells.at(1).members, (std::vector<std::uint32_t>{0}));
}

TEST(Sets, FaultsAndUnsupportedOptionsAreNamed) {
  const Read read =
      read_text(nodes_text(3) +
                "*SET_NODE_LIST\n1\n1,50,51\n*SET_NODE_LIST\n1\n2\n*SET_NODE_ADD\n2\n9\n"
                "*SET_NODE_GENERAL\n3\nSALECPT,1\nBOX,4\n*SET_NODE\n0\n1\n*SET_PART_LEAF\n1\n*SET_NODE\n");
  const std::string text = read.text();
  EXPECT_NE(text.find("node set 1 names 2 members that are not defined (50, 51)"), std::string::npos) << text;
  EXPECT_NE(text.find("node set 1 is defined again"), std::string::npos) << text;
  EXPECT_NE(text.find("node set 2 names a member that is not defined (9)"), std::string::npos) << text;
  EXPECT_NE(text.find("node set 3 names a member that is not defined (4)"), std::string::npos) << text;
  EXPECT_NE(text.find("the option SALECPT is not supported"), std::string::npos) << text;
  EXPECT_EQ(read.errors(), 2u) << text;
  EXPECT_EQ(node_ids(read.model, 1), (Ids{1}));
}

TEST(Sets, TooManyMembersInAllAreAnErrorAndNoMore) {
  std::string text = nodes_text(10000);
  std::string everything = "*SET_NODE_GENERAL\n1\n";
  text += everything + "ALL\n";
  // 40,000 sets of 10,000 nodes each from a deck of a megabyte.
  for (int i = 2; i < 40000; ++i) text += "*SET_NODE_ADD\n" + std::to_string(i) + "\n1\n";
  const Read read = read_text(text);
  EXPECT_EQ(read.errors(), 1u);
  EXPECT_NE(read.text().find("too many members"), std::string::npos);
}

/// Random steps of a general set against a plain walk over them.
TEST(Sets, GeneralAgreesWithAPlainWalk) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    std::string text = nodes_text(30) + "*SET_NODE_GENERAL\n1\n";
    Ids expected;
    for (int step = 0; step < 12; ++step) {
      const bool remove = random() % 3 == 0;
      text += remove ? "DNODE" : "NODE";
      for (int i = 0; i < 7; ++i) {
        const std::int64_t id = 1 + static_cast<std::int64_t>(random() % 30);
        text += "," + std::to_string(id);
        const auto there = std::find(expected.begin(), expected.end(), id);
        if (remove && there != expected.end()) expected.erase(there);
        if (!remove && there == expected.end()) expected.push_back(id);
      }
      text += "\n";
    }
    const Read read = read_text(text);
    EXPECT_EQ(node_ids(read.model, 1), expected);
  }
}

TEST(Boxes, GlobalAndLocal) {
  const Read read = read_text(
      "*DEFINE_BOX\n         1       0.0       1.0       0.0       2.0       0.0       3.0\n"
      "*DEFINE_BOX_LOCAL_TITLE\nturned\n2,0.,1.,0.,2.,0.,3.\n0.,1.,0.,-1.,0.,0.\n10.,0.,0.\n"
      "*DEFINE_BOX_LOCAL\n3,0.,1.,0.,1.,0.,1.\n0.,1.,0.,0.,2.,0.\n0.,0.,0.\n");
  ASSERT_EQ(read.model.boxes.size(), 3u) << read.text();
  EXPECT_TRUE(read.model.boxes.at(1).contains(Vector(0.5, 1.9, 2.9)));
  EXPECT_FALSE(read.model.boxes.at(1).contains(Vector(1.5, 1.9, 2.9)));
  EXPECT_TRUE(read.model.boxes.at(2).contains(Vector(8.5, 0.5, 1)));
  EXPECT_FALSE(read.model.boxes.at(2).contains(Vector(10.5, 0.5, 1)));
  EXPECT_EQ(read.errors(), 1u) << read.text();  // no plane
}

}  // namespace
}  // namespace gapcheck::model::sets_test
