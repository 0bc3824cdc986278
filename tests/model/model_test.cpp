#include "model/model.hpp"

#include <random>

#include "read.hpp"

namespace gapcheck::model::model_test {
namespace {

/// Every column is as long as the ids, and every index is one of the table that it means.
template <std::size_t N>
void expect_consistent(const Model& model, const Elements<N>& elements) {
  ASSERT_EQ(elements.nodes.size(), elements.id.size());
  ASSERT_EQ(elements.part.size(), elements.id.size());
  ASSERT_EQ(elements.line.size(), elements.id.size());
  for (const auto& nodes : elements.nodes)
    for (const NodeIndex node : nodes) ASSERT_TRUE(node == none<NodeIndex> || node.value < model.mesh.nodes.size());
  for (const PartIndex part : elements.part) ASSERT_TRUE(part == none<PartIndex> || part.value < model.parts.size());
}

void expect_consistent(const Model& model) {
  const Mesh& mesh = model.mesh;
  ASSERT_EQ(mesh.nodes.x.size(), mesh.nodes.id.size());
  ASSERT_EQ(mesh.nodes.line.size(), mesh.nodes.id.size());
  expect_consistent<4>(model, mesh.shells);
  expect_consistent(model, mesh.solids);
  expect_consistent(model, mesh.particles);
  for (const ShellThickness& own : mesh.shells.own_thickness) ASSERT_LT(own.shell, mesh.shells.size());
  for (const auto& [id, set] : model.sets.nodes)
    for (const NodeIndex node : set.members) ASSERT_LT(node.value, mesh.nodes.size()) << "node set " << id;
  for (const auto& [id, set] : model.sets.parts)
    for (const PartIndex part : set.members) ASSERT_LT(part.value, model.parts.size()) << "part set " << id;
  for (const Part& part : model.parts) {
    ASSERT_TRUE(!part.section || *part.section < model.sections.size());
    ASSERT_TRUE(!part.material || *part.material < model.materials.size());
  }
}

TEST(Model, SkippedKeywordsAreCounted) {
  const Read read = read_text(
      "*KEYWORD\n*TITLE\nabc\n*DEFINE_SD_ORIENTATION\n1\n0.,0.\n*DEFINE_SD_ORIENTATION\n2\n0.,0.\n*NODE\n1\n*END\n");
  EXPECT_EQ(read.model.skipped_keywords.at("DEFINE_SD_ORIENTATION"), 2u);
  EXPECT_FALSE(read.model.skipped_keywords.contains("NODE"));
  EXPECT_EQ(read.model.skipped_bytes, 2 * std::string("1\n0.,0.\n").size());
  EXPECT_EQ(read.text(), "");
}

TEST(Model, OrderInTheDeckDoesNotMatter) {
  const Read read =
      read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2\n\n\n*SET_PART_LIST\n1\n1\n*ELEMENT_SHELL\n1,1,1,2,3,4\n" +
                part_text + nodes_text(4));
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(read.model.mesh.shells.size(), 1u);
}

TEST(Model, RigidParts) {
  const Read read = read_text("*PART\na\n1,1,1\n*PART\nb\n2,1,2\n*MAT_RIGID\n2,1.,1.,0.3\n*MAT_ELASTIC\n1,1.,1.,0.3\n");
  EXPECT_FALSE(read.model.rigid(PartIndex{0}));
  EXPECT_TRUE(read.model.rigid(PartIndex{1}));
  EXPECT_FALSE(read.model.rigid(none<PartIndex>));
}

TEST(RigidGroups, AllKinds) {
  const Read read = read_text(
      nodes_text(9) + part_text + "*PART\nb\n2,1,1\n*SET_NODE_LIST\n5\n1,2,3\n*SET_PART_LIST\n6\n2\n" +
      "*CONSTRAINED_NODAL_RIGID_BODY\n        10         0         5\n         5\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA_TITLE\ntitle\n11,0,5\n1.,0,0\n0.,0.,0.,1.,1\n1.\n0.\n1.\n"
      "*CONSTRAINED_EXTRA_NODES_NODE\n1,7\n1,8\n2,9\n"
      "*CONSTRAINED_EXTRA_NODES_SET\n1,5\n*CONSTRAINED_RIGID_BODIES\n1,2\n*CONSTRAINED_RIGID_BODIES_SET\n1,6\n");
  const auto& groups = read.model.rigid_groups;
  ASSERT_EQ(groups.size(), 8u) << read.text();
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(groups[0].id, 10);
  EXPECT_EQ(groups[0].nodes.size(), 3u);
  EXPECT_EQ(groups[1].id, 5);  // the set of its own number
  EXPECT_EQ(groups[1].nodes.size(), 3u);
  EXPECT_EQ(groups[2].id, 11);
  EXPECT_EQ(groups[3].kind, RigidGroup::Kind::extra_nodes);
  EXPECT_EQ(groups[3].nodes, (std::vector<NodeIndex>{NodeIndex{6}, NodeIndex{7}}));
  EXPECT_EQ(groups[4].parts, (std::vector<PartIndex>{PartIndex{1}}));
  EXPECT_EQ(groups[5].nodes.size(), 3u);
  EXPECT_EQ(groups[6].kind, RigidGroup::Kind::merged_parts);
  EXPECT_EQ(groups[6].parts, (std::vector<PartIndex>{PartIndex{0}, PartIndex{1}}));
  EXPECT_EQ(groups[7].parts, groups[6].parts);
}

TEST(RigidGroups, UnknownReferences) {
  const Read read = read_text(
      "*CONSTRAINED_NODAL_RIGID_BODY\n1\n*CONSTRAINED_EXTRA_NODES_NODE\n1,1\n*CONSTRAINED_RIGID_BODIES\n1,2\n" +
      part_text +
      "*CONSTRAINED_RIGID_BODIES\n1,9\n*CONSTRAINED_EXTRA_NODES_NODE\n1,99\n*CONSTRAINED_RIGID_BODIES_SET\n1,8\n");
  EXPECT_EQ(read.faults(Fault::Kind::unknown_reference), 6u) << read.text();
}

TEST(Faults, AreSortedByKindAndPlace) {
  const Read read = read_text("*ELEMENT_SHELL\n1,1,1,2,3\n*NODE\n1\n2\n3\n1\n2\n*SET_NODE\n1\n9\n" + part_text);
  std::vector<std::pair<int, std::uint32_t>> order;
  for (const Fault& fault : read.model.faults) order.emplace_back(static_cast<int>(fault.kind), fault.place.line);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end())) << read.text();
  EXPECT_EQ(order.size(), 3u) << read.text();
}

TEST(Hostile, AbsurdCountsAndLetters) {
  const Read read = read_text(
      nodes_text(3) +
      "*SECTION_SHELL\n1,101,,9000000000000000000,,,1\n1.\n9000000000000000000\n*SECTION_SOLID\n2,101\n"
      "9000000000000000000,,,,9000000000000000000\n*PART_INERTIA\na\n1,1,1\n"
      "*CONTACT_DRAWBEAD\n1,2,2,2\n\n\n1,2,0.,0.,0,0,0,9000000000000000000\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED_WELD\n1,2,2,2\n\n\n1.,1.,1.,9223372036854775807\n"
      "*SET_NODE_LIST_GENERATE\n1\n-9223372036854775808,9223372036854775807\n"
      "*SET_NODE_LIST_GENERATE_INCREMENT\n2\n-9223372036854775808,9223372036854775807,9223372036854775807\n"
      "*SET_NODE_ADD\n3\n1,-9223372036854775808\n*ELEMENT_SPH\n1,1,0.1,9223372036854775807\n"
      "1,1,0.1,9223372036854775807\n"
      "*ELEMENT_SHELL\nx,y,z\n9223372036854775807,1,1,2,3\n*NODE\n99999999999999999999,1.,2.,3.\n7,nan,inf,1e999\n");
  EXPECT_GT(read.errors(), 0u);
  EXPECT_EQ(read.model.sets.nodes.at(1).members.size(), 4u);  // node 7 is one, its coordinates are errors
}

TEST(Hostile, TruncatedEverywhere) {
  const std::string whole =
      nodes_text(8) + part_text +
      "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n1.,1.,1.,1.\n*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,7,8\n"
      "*PART_COMPOSITE_CONTACT\nc\n3,2\n1.\n1,1.\n*SECTION_BEAM_TITLE\nt\n4,1\n1.,1.\n*SET_NODE_GENERAL_"
      "TITLE\nt\n1\nPART,1\n"
      "*SET_SEGMENT\n1\n1,2,3,4\n*DEFINE_BOX_LOCAL_TITLE\nt\n1,0.,1.,0.,1.,0.,1.\n1.,0.,0.,0.,1.,0.\n0.,0.,0.\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA_TITLE\nt\n1,0,1\n1.\n1.\n1.\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MPP_ID\n1t\n1\n&,1\n1,1,3,3\n0.1\n1.\n13\n1.\n1.\n1\n1.\n1\n";
  // Ends after any byte, and without any line: nothing may break.
  const Model complete = read_text(whole).model;
  EXPECT_EQ(complete.mesh.shells.size() + complete.mesh.solids.size(), 2u);
  ASSERT_EQ(complete.contacts.size(), 1u);
  for (std::size_t length = 1; length < whole.size(); length += 3) {
    const Model model = read_text(whole.substr(0, length)).model;
    expect_consistent(model);
    EXPECT_LE(model.mesh.nodes.size(), 8u);
    EXPECT_EQ(model.contacts.size(), length > whole.find("*CONTACT") + 7 ? 1u : 0u) << length;
  }
  for (std::size_t at = whole.find('\n'); at != std::string::npos; at = whole.find('\n', at + 1)) {
    const std::size_t next = whole.find('\n', at + 1);
    if (next != std::string::npos) expect_consistent(read_text(whole.substr(0, at) + whole.substr(next)).model);
  }
}

TEST(Hostile, RandomBytesInTheFields) {
  const std::string whole = nodes_text(8) + part_text +
                            "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,7,8\n"
                            "*SET_NODE_LIST_GENERATE\n1\n1,5\n*SET_NODE_ADD\n2\n1,2\n*SET_PART_GENERAL\n1\nALL\n"
                            "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n1\n1,0,2\n\n\n\n\n";
  std::mt19937 random(3);
  const std::string letters = "0123456789.,-+eE&<>$ \n\tAZ_*";
  std::size_t with_shells = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = whole;
    for (int i = 0; i < 8; ++i) text[random() % text.size()] = letters[random() % letters.size()];
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck_text(text, "a.k", {}, diagnostics);
    ASSERT_TRUE(deck.ok());
    const auto model = read_model(deck.value(), diagnostics);
    ASSERT_TRUE(model.ok());
    expect_consistent(model.value());
    with_shells += model.value().mesh.shells.size() > 0 ? 1 : 0;
  }
  EXPECT_GT(with_shells, 500u) << "many texts still have their shell";
}

TEST(Hostile, ManyContactsAndPartsAreRead) {
  std::string text;
  for (int i = 1; i <= 20000; ++i)
    text += "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n\n\n*PART\na\n" + std::to_string(i) + ",1,1\n";
  const Read read = read_text(text);
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(read.model.contacts.size(), 20000u);
  EXPECT_EQ(read.model.parts.size(), 20000u);
  EXPECT_EQ(read.model.contacts.back().id, ContactId{20000});
}

TEST(Transform, MovesIdsLengthsAndPlaces) {
  // What an include with offsets brings, is looked for under the new ids.
  const std::string path = testing::TempDir() + "/gapcheck_model_included.k";
  FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  const std::string included =
      nodes_text(4) + part_text +
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n1,1\n1,2,3,4\n*SET_PART_LIST\n1\n1\n*SET_NODE_GENERAL\n2\nPART,1\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,1,2,3\n\n,,0.5\n";
  std::fputs(included.c_str(), file);
  std::fclose(file);
  const Read read = read_text("*INCLUDE_TRANSFORM\n" + path +
                              "\n      1000      2000      3000      4000      5000      6000      7000\n      8000\n"
                              "       1.0       1.0      10.0\n\n");
  std::remove(path.c_str());
  EXPECT_EQ(read.text(), "");
  const Model& model = read.model;
  ASSERT_EQ(model.mesh.nodes.size(), 4u);
  EXPECT_EQ(model.mesh.nodes.id[0], 1001);
  EXPECT_EQ(model.mesh.nodes.x[0], Vector(10, 100, 1000));
  EXPECT_EQ(model.mesh.shells.id[0], 2001);
  EXPECT_EQ(model.mesh.solids.id[0], 2001);
  EXPECT_EQ(model.parts[0].id, PartId{3001});
  EXPECT_EQ(model.parts[0].material_id, 4001);
  EXPECT_EQ(model.sections[0].thickness[0], 20.0);
  ASSERT_TRUE(model.sets.parts.contains(5001));
  EXPECT_EQ(model.sets.nodes.at(5002).members.size(), 4u);
  EXPECT_EQ(model.contacts.at(0).a.id, 5001);
  EXPECT_EQ(model.contacts.at(0).b.id, 3001);
  EXPECT_EQ(model.contacts.at(0).sst, 5.0);
}

}  // namespace
}  // namespace gapcheck::model::model_test
