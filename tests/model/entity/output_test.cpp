#include "model/entity/output.hpp"

#include "model/read.hpp"

namespace gapcheck::model::output_test {
namespace {

TEST(Output, IntervalsAndTitle) {
  const Read read = read_text(
      "*TITLE\n  A model of something\n*DATABASE_BINARY_D3PLOT\n       0.5\n         1\n*DATABASE_GLSTAT\n     0.125\n"
      "*DATABASE_MATSUM\n0.25\n*DATABASE_NODOUT\n0.1,0,0\n*DATABASE_RCFORC\n0.2\n*DATABASE_SLEOUT\n0.3\n"
      "*DATABASE_NCFORC\n0.4\n*DATABASE_ELOUT\n7.\n*DATABASE_SECFORC\n0.6\n*DATABASE_SPCFORC\n0.7\n*DATABASE_BNDOUT\n0."
      "8\n"
      "*DATABASE_RWFORC\n0.9\n*DATABASE_RBDOUT\n1.1\n*DATABASE_SWFORC\n1.2\n*DATABASE_DEFORC\n1.3\n*DATABASE_"
      "JNTFORC\n1.4\n*CONTROL_OUTPUT\n\n,,,,,,,1\n");
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
  EXPECT_EQ(output.elout, 7);
  EXPECT_EQ(output.secforc, 0.6);
  EXPECT_EQ(output.spcforc, 0.7);
  EXPECT_EQ(output.bndout, 0.8);
  EXPECT_EQ(output.rwforc, 0.9);
  EXPECT_EQ(output.rbdout, 1.1);
  EXPECT_EQ(output.swforc, 1.2);
  EXPECT_EQ(output.deforc, 1.3);
  EXPECT_EQ(output.jntforc, 1.4);
  EXPECT_TRUE(output.local_shells);
  EXPECT_TRUE(output.notes.empty());
}

TEST(Output, FilesThatARunDoesNotWriteAreNamedOnce) {
  const Read read = read_text(
      "*DATABASE_GLSTAT\n0.1\n*DATABASE_DISBOUT\n0.5\n*DATABASE_NODFOR\n0.\n*DATABASE_SBTOUT\n,,7\n*DATABASE_DISBOUT\n"
      "0.5\n*DATABASE_BINARY_D3THDT\n0.5\n*DATABASE_SSSTAT\n*DATABASE_NODOUT_HF\n0.1\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.output.all_notes().size(), 1u);
  EXPECT_EQ(read.model.output.all_notes()[0].place.line, 4u);
  EXPECT_EQ(
      read.model.output.all_notes()[0].text,
      "the deck asks for files that a run does not write: disbout, sbtout, d3thdt, the second nodout of the nodes "
      "with HFO (*DATABASE_NODOUT_HF)")
      << "no interval: not asked for; sbtout has a curve of them";
}

TEST(Output, WhatCannotBeDoneIsNoted) {
  const Read read = read_text(
      "*DATABASE_GLSTAT\n-1.,0,7\n*DATABASE_MATSUM\n0.\n*DATABASE_RCFORC\n*DATABASE_SECFORC_FILTER\n0.5\n0.1,60.\n");
  EXPECT_EQ(read.model.output.glstat, 0);
  ASSERT_EQ(read.model.output.notes.size(), 3u);
  EXPECT_EQ(read.model.output.secforc, 0.5);
  EXPECT_NE(read.model.output.notes[2].text.find("not filtered"), std::string::npos);
  EXPECT_EQ(read.model.output.notes[0].place.line, 2u);
  EXPECT_NE(read.model.output.notes[0].text.find("curve"), std::string::npos);
  EXPECT_NE(read.model.output.notes[1].text.find("DT = -1"), std::string::npos);
}

TEST(Output, HistoryElements) {
  const Read read = read_text(nodes_text(8) +
                              "*ELEMENT_SOLID\n5,1,1,2,3,4,5,6,7,8\n6,1,1,2,3,4,5,6,7,8\n*ELEMENT_SHELL\n9,1,1,2,3,4\n"
                              "*ELEMENT_BEAM\n4,1,1,2\n*DATABASE_HISTORY_SOLID_SET\n8,7\n*SET_SOLID\n8\n6\n"
                              "*DATABASE_HISTORY_SOLID\n6,5,99\n*DATABASE_HISTORY_SHELL_ID\n         9the shell\n"
                              "*DATABASE_HISTORY_BEAM\n4\n*DATABASE_HISTORY_TSHELL\n3\n"
                              "*DATABASE_HISTORY_NODE_LOCAL\n1,7\n");
  const Output& output = read.model.output;
  ASSERT_EQ(output.history_solids.size(), 2u);
  EXPECT_EQ(output.history_solids[0].element, 1u);
  EXPECT_EQ(output.history_solids[1].element, 0u);
  ASSERT_EQ(output.history_shells.size(), 1u);
  EXPECT_EQ(output.history_shells[0].title, "the shell");
  EXPECT_EQ(output.history_beams.size(), 1u);
  EXPECT_TRUE(output.history_nodes.empty());
  std::string notes;
  for (const Output::Note& note : output.notes) notes += note.text + "\n";
  for (const char* words : {"solid set 7", "solid 99", "*DATABASE_HISTORY_TSHELL", "*DATABASE_HISTORY_NODE_LOCAL"})
    EXPECT_NE(notes.find(words), std::string::npos) << words << "\n" << notes;
}

TEST(Output, CrossSections) {
  const Read read = read_text(
      "*DATABASE_CROSS_SECTION_PLANE_ID\n         7the cut\n0,1.,0.,0.,2.,0.,0.,0.5\n,,,,,3,1\n"
      "*DATABASE_CROSS_SECTION_SET\n1,2,3,4,5,6\n");
  ASSERT_EQ(read.model.cross_sections.size(), 2u);
  const CrossSection &plane = read.model.cross_sections[0], &set = read.model.cross_sections[1];
  EXPECT_EQ(plane.id, 7);
  EXPECT_EQ(plane.title, "the cut");
  EXPECT_EQ(plane.system, 3);
  EXPECT_EQ(plane.kind_of_system, 1);
  EXPECT_EQ(set.nodes, 1);
  EXPECT_EQ(set.solids, 2);
  EXPECT_EQ(set.beams, 3);
  EXPECT_EQ(set.shells, 4);
  EXPECT_EQ(set.others, 5);
}

// What LS-DYNA would add to intfor has no known place there: it is named.
TEST(Output, InterfaceValuesThatAreNotWrittenAreNamed) {
  const Read read = read_text("*CONTROL_CONTACT\n\n\n\n1,1\n*DATABASE_EXTENT_INTFOR\n1,1,1,1,1,1\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.output.notes.size(), 2u);
  EXPECT_NE(read.model.output.notes[0].text.find("FRCENG = 1"), std::string::npos);
  EXPECT_EQ(read.model.output.notes[0].place.line, 5u);
  EXPECT_NE(read.model.output.notes[1].text.find("gaps, energies and wear are not written"), std::string::npos);
  EXPECT_EQ(read.model.output.notes[1].place.line, 6u);
  EXPECT_TRUE(read_text("*CONTROL_CONTACT\n\n\n\n1\n").model.output.notes.empty());
}

TEST(Output, InterfaceForces) {
  const Read read = read_text("*NODE\n1\n*DATABASE_BINARY_INTFOR_FILE\nforces.dat\n0.5,3\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(read.model.output.intfor, 0.5);
  EXPECT_EQ(read.model.output.intfor_place.line, 5u);
  ASSERT_EQ(read.model.output.notes.size(), 2u);
  EXPECT_NE(read.model.output.notes[0].text.find("curve"), std::string::npos);
  EXPECT_NE(read.model.output.notes[1].text.find("is called intfor"), std::string::npos);
  EXPECT_EQ(read_text("*DATABASE_BINARY_INTFOR\n0.25\n").model.output.intfor, 0.25);
  const Read without = read_text("*DATABASE_BINARY_INTFOR\n-2.\n*DATABASE_BINARY_INTFOR\n");
  EXPECT_EQ(without.model.output.intfor, 0);
  EXPECT_NE(without.model.output.notes.at(0).text.find("DT = -2"), std::string::npos);
}

TEST(Output, Binary) {
  const Read read = read_text(
      "*DATABASE_GLSTAT\n0.1,2\n*DATABASE_RCFORC\n0.1,3\n*DATABASE_SLEOUT\n0.1\n*DATABASE_NCFORC\n0.1,3\n"
      "*DATABASE_NODOUT\n0.1,-4\n*DATABASE_MATSUM\n0.1,12\n");
  const Output& output = read.model.output;
  EXPECT_EQ(output.binary, (std::map<std::string, int, std::less<>>{{"glstat", 2}, {"rcforc", 3}, {"sleout", 0}}));
  ASSERT_EQ(output.notes.size(), 3u);
  EXPECT_NE(output.notes[0].text.find("ncforc is written as text"), std::string::npos);
  EXPECT_NE(output.notes[1].text.find("BINARY = -4 is none of"), std::string::npos);
  EXPECT_NE(output.notes[2].text.find("BINARY = 12 is none of"), std::string::npos);
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
