#include "model/read/elements.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/parallel.hpp"
#include "model/read.hpp"

namespace gapcheck::model::elements_test {
namespace {

std::string start(int nodes = 20) { return nodes_text(nodes) + part_text; }

/// The ids of an element's nodes.
template <std::size_t N>
std::vector<std::int64_t> node_ids(const Model& model, const Elements<N>& elements, std::size_t i) {
  std::vector<std::int64_t> ids;
  for (const NodeIndex node : elements.nodes.at(i))
    ids.push_back(node == none<NodeIndex> ? 0 : model.mesh.nodes.id.at(node.value));
  return ids;
}
using Ids = std::vector<std::int64_t>;

TEST(Shells, QuadsAndBothKindsOfTriangles) {
  const Read read = read_text(start() +
                              "*ELEMENT_SHELL\n"
                              "      11       1       1       2       3       4\n"
                              "      12       1       1       2       3       3\n"
                              "13,1,1,2,3\n"
                              "      14       1       1       2       3       4       5       6       7       8\n");
  const Shells& shells = read.model.mesh.shells;
  ASSERT_EQ(shells.size(), 4u) << read.text();
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(node_ids(read.model, shells, 0), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(node_ids(read.model, shells, 1), (Ids{1, 2, 3, 3}));
  EXPECT_EQ(node_ids(read.model, shells, 2), (Ids{1, 2, 3, 3}));
  EXPECT_EQ(node_ids(read.model, shells, 3), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(shells.part[0], PartIndex{0});
  EXPECT_EQ(shells.lookup.find(13), 2u);
  EXPECT_TRUE(shells.own_thickness.empty());
}

TEST(Shells, ThicknessLinesAndMiddleNodes) {
  const Read read = read_text(start() +
                              "*ELEMENT_SHELL_THICKNESS\n"
                              "11,1,1,2,3,4\n"
                              "             1.5             1.6             1.7             1.8            30.0\n"
                              "12,1,5,6,7,8\n"
                              "\n"
                              "13,1,1,2,3,4,5,6,7,8\n"
                              "2.,2.,2.,2.\n"
                              "3.,3.,3.,3.\n"
                              "14,1,9,10,11,12\n"
                              "4.,0.,0.,0.\n");
  const Shells& shells = read.model.mesh.shells;
  ASSERT_EQ(shells.size(), 4u) << read.text();
  ASSERT_EQ(shells.own_thickness.size(), 3u);
  EXPECT_EQ(shells.own_thickness[0].shell, 0u);
  EXPECT_EQ(shells.own_thickness[0].thickness, (std::array<double, 4>{1.5, 1.6, 1.7, 1.8}));
  EXPECT_EQ(shells.own_thickness[1].shell, 2u);
  EXPECT_EQ(shells.own_thickness[1].thickness, (std::array<double, 4>{2, 2, 2, 2}));
  EXPECT_EQ(shells.own_thickness[2].shell, 3u);
  EXPECT_EQ(shells.own_thickness[2].thickness, (std::array<double, 4>{4, 0, 0, 0}));
}

TEST(Shells, OptionsCombine) {
  const Read read = read_text(start() +
                              "*ELEMENT_SHELL_BETA_OFFSET\n1,1,1,2,3,4\n,,,,45.\n0.25\n2,1,1,2,3,4\n,,,,45.\n0.0\n"
                              "*ELEMENT_SHELL_OFFSET\n3,1,1,2,3,4\n-0.5\n"
                              "*ELEMENT_SHELL_DOF\n4,1,1,2,3,4\n,,5,6,7,8\n5,1,1,2,3,4\n,,5,6,7,8\n");
  const Shells& shells = read.model.mesh.shells;
  ASSERT_EQ(shells.size(), 5u) << read.text();
  EXPECT_EQ(read.text(), "");
  EXPECT_TRUE(shells.own_thickness.empty());
  ASSERT_EQ(shells.own_offset.size(), 2u);
  EXPECT_EQ(shells.own_offset[0].shell, 0u);
  EXPECT_EQ(shells.own_offset[0].offset, 0.25);
  EXPECT_EQ(shells.own_offset[1].shell, 2u);
  EXPECT_EQ(shells.own_offset[1].offset, -0.5);
}

TEST(Shells, PliesOfCompositesAddUp) {
  const Read read = read_text(start() +
                              "*ELEMENT_SHELL_COMPOSITE\n"
                              "      11       1       1       2       3       4\n"
                              "         1      0.25      45.0                   1      0.75      90.0\n"
                              "         1       0.5      45.0\n"
                              "      12       1       1       2       3       4\n"
                              "         1       1.0      45.0                   1       1.0      90.0\n"
                              "*ELEMENT_SHELL_OFFSET_COMPOSITE_LONG\n"
                              "      13       1       1       2       3       4\n"
                              "            -0.5\n"
                              "         1      0.25      45.0                  77\n"
                              "         1      0.25      45.0                  78\n");
  const Shells& shells = read.model.mesh.shells;
  ASSERT_EQ(shells.size(), 3u) << read.text();
  ASSERT_EQ(shells.own_thickness.size(), 3u);
  EXPECT_EQ(shells.own_thickness[0].thickness, (std::array<double, 4>{1.5, 1.5, 1.5, 1.5}));
  EXPECT_EQ(shells.own_thickness[1].thickness, (std::array<double, 4>{2, 2, 2, 2}));
  EXPECT_EQ(shells.own_thickness[2].thickness, (std::array<double, 4>{0.5, 0.5, 0.5, 0.5}));
  ASSERT_EQ(shells.own_offset.size(), 1u);
}

TEST(Shells, SideTablesFollowWhenShellsAreLeftOut) {
  const Read read = read_text(start() +
                              "*ELEMENT_SHELL_THICKNESS\n"
                              "1,1,1,2,3,4\n1.,1.,1.,1.\n"
                              "2,1,1,2,3,99\n2.,2.,2.,2.\n"
                              "3,1,1,2,3,4\n3.,3.,3.,3.\n"
                              "1,1,1,2,3,4\n4.,4.,4.,4.\n"
                              "5,1,1,2,3,4\n5.,5.,5.,5.\n");
  const Shells& shells = read.model.mesh.shells;
  EXPECT_EQ(shells.id, (Ids{1, 3, 5}));
  ASSERT_EQ(shells.own_thickness.size(), 3u);
  for (const ShellThickness& own : shells.own_thickness)
    EXPECT_EQ(own.thickness[0], static_cast<double>(shells.id[own.shell]));
  EXPECT_EQ(read.faults(Fault::Kind::unknown_reference), 1u) << read.text();
  EXPECT_EQ(read.faults(Fault::Kind::duplicate_id), 1u) << read.text();
}

TEST(Solids, OneAndTwoLinesMayMix) {
  const Read read = read_text(start() +
                              "*ELEMENT_SOLID\n"
                              "       1       1       1       2       3       4       5       6       7       8\n"
                              "       2       1\n"
                              "      11      12      13      14      15      16      17      18       0       0\n"
                              "3,1\n"
                              "1,2,3,4,5,6,7,8,9,10\n"
                              "4,1,1,2,3,4\n"
                              "5,1,1,2,3,4,5,5,6,6\n"
                              "6,1\n1,2,3,4,4,4,4,4\n");
  const auto& solids = read.model.mesh.solids;
  ASSERT_EQ(solids.size(), 6u) << read.text();
  EXPECT_EQ(node_ids(read.model, solids, 0), (Ids{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(node_ids(read.model, solids, 1), (Ids{11, 12, 13, 14, 15, 16, 17, 18}));
  EXPECT_EQ(node_ids(read.model, solids, 2), (Ids{1, 2, 3, 4, 4, 4, 4, 4}));  // ten nodes: a tetrahedron
  EXPECT_EQ(node_ids(read.model, solids, 3), (Ids{1, 2, 3, 4, 4, 4, 4, 4}));
  EXPECT_EQ(node_ids(read.model, solids, 4), (Ids{1, 2, 3, 4, 5, 5, 6, 6}));
  EXPECT_EQ(node_ids(read.model, solids, 5), (Ids{1, 2, 3, 4, 4, 4, 4, 4}));
  EXPECT_EQ(solids.line[1], static_cast<std::uint32_t>(solids.line[0] + 1));
}

TEST(Solids, FormsWithMoreLines) {
  const std::string second = "11,12,13,14,15,16,17,18,19,20\n";
  const Read read = read_text(start() +
                              "*ELEMENT_SOLID_ORTHO\n1,1,1,2,3,4,5,6,7,8\n1.,0.,0.\n0.,1.,0.\n2,1\n1,2,3,4,5,6,7,8\n"
                              "1.,0.,0.\n0.,1.,0.\n"
                              "*ELEMENT_SOLID_H20\n3,1\n1,2,3,4,5,6,7,8,9,10\n" +
                              second + "4,1\n2,3,4,5,6,7,8,9,9,10\n" + second +
                              "*ELEMENT_SOLID_T15\n5,1\n1,2,3,4,5,6,7,8,9,10\n11,12,13,14,15\n");
  const auto& solids = read.model.mesh.solids;
  ASSERT_EQ(solids.size(), 5u) << read.text();
  EXPECT_EQ(solids.id, (Ids{1, 2, 3, 4, 5}));
  EXPECT_EQ(node_ids(read.model, solids, 3), (Ids{2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(node_ids(read.model, solids, 4), (Ids{1, 2, 3, 4, 4, 4, 4, 4}));
}

TEST(OtherElements, AreRead) {
  const Read read = read_text(start() +
                              "*ELEMENT_TSHELL\n1,1,1,2,3,4,5,6,7,8\n2,1,1,2,3,4,5,6\n"
                              "*ELEMENT_TSHELL_COMPOSITE\n"
                              "       3       1       1       2       3       4       5       6       7       8\n"
                              "         1      0.25      45.0\n"
                              "       4       1       1       2       3       4       5       6       7       8\n"
                              "*ELEMENT_BEAM\n1,1,1,2,3\n*ELEMENT_BEAM_THICKNESS_OFFSET\n2,1,3,4\n1.,1.\n0.,0.,0.\n"
                              "3,1,3,4\n1.,1.\n0.,0.,0.\n"
                              "*ELEMENT_DISCRETE\n1,1,1,0\n2,1,1,2\n"
                              "*ELEMENT_MASS\n       1       5             2.5\n2,6,1.5,1\n"
                              "*ELEMENT_INERTIA\n3,7\n0.,0.,0.,0.,0.,0.,9.5\n"
                              "*ELEMENT_SPH\n       8       1             0.5\n9,1,0.5,12\n");
  const Mesh& mesh = read.model.mesh;
  EXPECT_EQ(mesh.thick_shells.size(), 4u) << read.text();
  EXPECT_EQ(node_ids(read.model, mesh.thick_shells, 1), (Ids{1, 2, 3, 4, 5, 6, 6, 6}));
  ASSERT_EQ(mesh.beams.size(), 3u);
  EXPECT_EQ(node_ids(read.model, mesh.beams, 2), (Ids{3, 4}));
  ASSERT_EQ(mesh.discrete.size(), 2u);
  EXPECT_EQ(node_ids(read.model, mesh.discrete, 0), (Ids{1, 0}));
  EXPECT_EQ(node_ids(read.model, mesh.discrete, 1), (Ids{1, 2}));
  EXPECT_EQ(mesh.mass_values, (std::vector<double>{2.5, 1.5, 9.5}));
  EXPECT_EQ(mesh.masses.part[0], none<PartIndex>);
  EXPECT_EQ(mesh.masses.part[1], PartIndex{0});
  EXPECT_EQ(mesh.particles.id, (Ids{8, 9, 10, 11, 12}));
  EXPECT_EQ(read.errors(), 0u) << read.text();
  EXPECT_EQ(read.warnings(), 1u) << read.text();  // the beams' own thickness
}

TEST(OtherElements, BeamAndSpringValues) {
  const Read read = read_text(start() +
                              "*ELEMENT_BEAM\n1,1,1,2,3\n2,1,2,77\n3,1,3,4,,1\n"
                              "*ELEMENT_BEAM_OFFSET_ORIENTATION\n4,1,3,4\n0.,0.,1.\n0.,0.5,1.\n"
                              "*ELEMENT_DISCRETE\n"
                              "       1       1       1       0       0             2.5       0             0.1\n"
                              "       2       1       1       2       9\n");
  const Mesh& mesh = read.model.mesh;
  ASSERT_EQ(mesh.beams.id, (Ids{1, 3, 4})) << read.text();
  ASSERT_EQ(mesh.beam_values.size(), 3u);
  EXPECT_EQ(mesh.beam_values[0].third, NodeIndex{2});
  EXPECT_FALSE(mesh.beam_values[0].released());
  EXPECT_EQ(mesh.beam_values[1].third, none<NodeIndex>);
  EXPECT_TRUE(mesh.beam_values[1].released());
  EXPECT_EQ(mesh.beam_values[1].releases, (std::array<std::uint8_t, 4>{1, 0, 0, 0}));
  EXPECT_TRUE(mesh.beam_values[2].shifted());
  EXPECT_EQ(mesh.beam_values[2].offsets[0], Vector(0, 0, 1));
  EXPECT_EQ(mesh.beam_values[2].orientation, Vector(0, 0.5, 1));
  ASSERT_EQ(mesh.discrete_values.size(), 2u);
  EXPECT_EQ(mesh.discrete_values[0].scale, 2.5);
  EXPECT_EQ(mesh.discrete_values[0].offset, 0.1);
  EXPECT_EQ(mesh.discrete_values[1].scale, 1);
  EXPECT_EQ(mesh.discrete_values[1].orientation, 9);
}

TEST(Elements, FaultsAreNamed) {
  const Read read =
      read_text(start() + "*ELEMENT_SHELL\n1,1,1,2,3,77\n2,5,1,2,3,4\n3,5,1,2,3,4\n4,1,1,2\n4,1,1,2,3\n4,1,1,2,3\n");
  const Shells& shells = read.model.mesh.shells;
  EXPECT_EQ(shells.id, (Ids{2, 3, 4}));
  EXPECT_EQ(shells.part[0], none<PartIndex>);
  const std::string text = read.text();
  EXPECT_NE(text.find("shell 1 names node 77, which is not defined"), std::string::npos) << text;
  EXPECT_NE(text.find("shell 4 names node 0, which is not defined"), std::string::npos) << text;
  EXPECT_NE(text.find("part 5 is not defined, but 2 elements use it (first: shell 2)"), std::string::npos) << text;
  EXPECT_NE(text.find("shell 4 is defined again"), std::string::npos) << text;
  EXPECT_EQ(read.model.faults.size(), 4u);
}

/// Long enough for many pieces of the text; some rows are bad, and comments stand between them.
TEST(Elements, FaultsOfLongBlocksComeInTheOrderOfTheFile) {
  std::string text = start() + "*ELEMENT_SHELL\n";
  Ids good;
  std::vector<std::uint32_t> lines;
  auto line = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
  std::string expected;
  for (int i = 1; i <= 20000; ++i) {
    if (i % 700 == 0) text += "$ comment\n\n";
    line += i % 700 == 0 ? 3 : 1;
    char row[80];
    const int id = i % 5000 == 17 ? -i : i, node = i % 3000 == 5 ? 77 + i : 4, part = i % 4000 == 9 ? 5 + i % 3 : 1;
    std::snprintf(row, sizeof row, "%8d%8d%8d%8d%8d%8d\n", id, part, 1, 2, 3, node);
    text += row;
    if (id < 0 || node != 4) {
      expected += std::to_string(line) + (id < 0 ? " id\n" : " node\n");
      continue;
    }
    good.push_back(i);
    lines.push_back(line);
  }
  std::optional<std::string> first;
  for (const std::size_t jobs : {1, 2, 5}) {
    const JobLimit limit(jobs);
    const Read read = read_text(text);
    EXPECT_EQ(read.model.mesh.shells.id, good);
    EXPECT_EQ(read.model.mesh.shells.line, lines);
    std::vector<std::pair<std::uint32_t, std::string>> found;
    for (const Diagnostic& d : read.diagnostics)
      if (d.message.find("is not positive") != std::string::npos) found.emplace_back(d.line, " id\n");
    for (const Fault& fault : read.model.faults)
      if (fault.message.find("names node") != std::string::npos) found.emplace_back(fault.place.line, " node\n");
    std::sort(found.begin(), found.end());
    std::string all;
    for (const auto& [number, what] : found) all += std::to_string(number) + what;
    EXPECT_EQ(all, expected);
    EXPECT_NE(read.text().find("part 5 is not defined, but 2 elements use it (first: shell 9)"), std::string::npos);
    if (!first) first = read.text();
    EXPECT_EQ(read.text(), *first);
  }
}

// A part needs a section and a material once anything but a mass is made of it.
TEST(Elements, PropertiesOfPartsWithElementsMustBeThere) {
  for (const char* block : {"SHELL\n1,2,1,2,3,4\n", "SOLID\n1,2,1,2,3,4,5,6,7,8\n", "TSHELL\n1,2,1,2,3,4,5,6,7,8\n",
                            "BEAM\n1,2,1,2\n", "DISCRETE\n1,2,1,2\n", "SPH\n1,2,0.5\n", "MASS\n1,5,2.5,2\n"}) {
    const Read read = read_text(nodes_text(8) + "*PART\na\n2,8,9\n*ELEMENT_" + block);
    const bool mass = std::string(block).starts_with("MASS");
    EXPECT_EQ(read.faults(Fault::Kind::unknown_reference), mass ? 0u : 2u) << block << read.text();
  }
}

TEST(Elements, FormsThatAreNotReadAreNamed) {
  const Read read = read_text(start() + "*ELEMENT_SHELL_NURBS_PATCH\n1\n*ELEMENT_SEATBELT\n1\n");
  EXPECT_EQ(read.warnings(), 1u) << read.text();
  EXPECT_NE(read.text().find("*ELEMENT_SHELL_NURBS_PATCH"), std::string::npos) << read.text();
  EXPECT_EQ(read.model.skipped_keywords.at("ELEMENT_SHELL_NURBS_PATCH"), 1u);
  EXPECT_EQ(read.model.skipped_keywords.at("ELEMENT_SEATBELT"), 1u);
}

TEST(Elements, FilesOfManyBlocksAreKept) {
  std::string text = start(4);
  for (int i = 1; i <= 300; ++i) text += "*ELEMENT_SHELL_OFFSET\n" + std::to_string(i) + ",1,1,2,3,4\n0.5\n";
  const Read read = read_text(text);
  ASSERT_EQ(read.model.mesh.shells.size(), 300u);
  EXPECT_EQ(read.model.mesh.shells.own_offset.size(), 300u);
  EXPECT_EQ(read.model.mesh.shells.own_offset[299].shell, 299u);
}

}  // namespace
}  // namespace gapcheck::model::elements_test
