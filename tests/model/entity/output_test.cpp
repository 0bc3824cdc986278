#include "model/entity/output.hpp"

#include "model/read.hpp"

namespace gapcheck::model::output_test {
namespace {

TEST(Output, IntervalsAndTitle) {
  const Read read = read_text(
      "*TITLE\n  A model of something\n*DATABASE_BINARY_D3PLOT\n       0.5\n         1\n*DATABASE_GLSTAT\n     0.125\n"
      "*DATABASE_MATSUM\n0.25\n*DATABASE_NODOUT\n0.1,0,0\n*DATABASE_RCFORC\n0.2\n*DATABASE_SLEOUT\n0.3\n"
      "*DATABASE_NCFORC\n0.4\n*DATABASE_ELOUT\n7.\n");
  EXPECT_EQ(read.text(), "");
  const Output& output = read.model.output;
  EXPECT_EQ(read.model.title, "A model of something");
  EXPECT_EQ(output.d3plot, 0.5);
  EXPECT_EQ(output.glstat, 0.125);
  EXPECT_EQ(output.matsum, 0.25);
  EXPECT_EQ(output.nodout, 0.1);
  EXPECT_EQ(output.rcforc, 0.2);
  EXPECT_EQ(output.sleout, 0.3);
  EXPECT_EQ(output.ncforc, 0.4);
  EXPECT_TRUE(output.notes.empty());
}

TEST(Output, FilesThatARunDoesNotWriteAreNamedOnce) {
  const Read read = read_text(
      "*DATABASE_GLSTAT\n0.1\n*DATABASE_ELOUT\n0.5\n*DATABASE_SECFORC\n0.\n*DATABASE_RWFORC\n,,7\n*DATABASE_ELOUT\n"
      "0.5\n*DATABASE_BINARY_INTFOR_FILE\nforces.dat\n0.5\n*DATABASE_BNDOUT\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.output.all_notes().size(), 1u);
  EXPECT_EQ(read.model.output.all_notes()[0].place.line, 4u);
  EXPECT_EQ(read.model.output.all_notes()[0].text,
            "the deck asks for files that a run does not write: elout, rwforc, intfor")
      << "no interval: not asked for; rwforc has a curve of them";
}

TEST(Output, WhatCannotBeDoneIsNoted) {
  const Read read = read_text("*DATABASE_GLSTAT\n-1.,0,7\n*DATABASE_MATSUM\n0.\n*DATABASE_RCFORC\n");
  EXPECT_EQ(read.model.output.glstat, 0);
  ASSERT_EQ(read.model.output.notes.size(), 2u);
  EXPECT_EQ(read.model.output.notes[0].place.line, 2u);
  EXPECT_NE(read.model.output.notes[0].text.find("curve"), std::string::npos);
  EXPECT_NE(read.model.output.notes[1].text.find("DT = -1"), std::string::npos);
}

TEST(Output, HistoryNodes) {
  const Read read = read_text(nodes_text(6) +
                              "*DATABASE_HISTORY_NODE\n         3         1         0        99\n"
                              "*DATABASE_HISTORY_NODE_ID\n         5the fifth node\n         3again\n"
                              "*DATABASE_HISTORY_NODE_SET\n         8         9\n"
                              "*SET_NODE_LIST\n         8\n         6         1\n");
  const Output& output = read.model.output;
  std::vector<std::int64_t> ids;
  for (const HistoryNode& entry : output.history_nodes) ids.push_back(read.model.mesh.nodes.id[entry.node.value]);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{3, 1, 5, 6}));
  EXPECT_EQ(output.history_nodes[2].title, "the fifth node");
  ASSERT_EQ(output.notes.size(), 2u);
  EXPECT_NE(output.notes[0].text.find("node 99"), std::string::npos);
  EXPECT_NE(output.notes[1].text.find("node set 9"), std::string::npos);
}

// Includes scale the time and shift the ids.
TEST(Output, IncludeTransforms) {
  const std::string path = testing::TempDir() + "/gapcheck_output_included.k";
  FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  const std::string included = nodes_text(4) + "*DATABASE_HISTORY_NODE\n4\n*DATABASE_GLSTAT\n0.5\n*TITLE\nincluded\n";
  std::fputs(included.c_str(), file);
  std::fclose(file);
  const Read read = read_text("*TITLE\nfirst\n*INCLUDE_TRANSFORM\n" + path +
                              "\n      1000      2000      3000      4000      5000      6000      7000\n      8000\n"
                              "       1.0       4.0       1.0\n\n");
  std::remove(path.c_str());
  ASSERT_EQ(read.model.output.history_nodes.size(), 1u);
  EXPECT_EQ(read.model.mesh.nodes.id[read.model.output.history_nodes[0].node.value], 1004);
  EXPECT_EQ(read.model.output.glstat, 2);
  EXPECT_EQ(read.model.title, "first");
}

}  // namespace
}  // namespace gapcheck::model::output_test
