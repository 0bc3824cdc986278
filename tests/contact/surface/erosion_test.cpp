#include "contact/surface/erosion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/scene.hpp"
#include "model/read.hpp"

namespace gapcheck::contact::erosion_test {
namespace {

/// Three bricks in a row along x, one plate of two shells in front of the first one at x = -1, an eroding contact.
std::string row(const std::string& contact, const std::string& more = "") {
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      nodes += fmt::format("{},{}.,{}.,{}.\n", 4 * i + k + 1, i, k == 1 || k == 2 ? 1 : 0, k / 2);
  for (int i = 0; i < 3; ++i) {
    solids += fmt::format("{},1", i + 1);
    for (int k = 1; k <= 8; ++k) solids += fmt::format(",{}", 4 * i + k);
    solids += "\n";
  }
  return nodes + "101,-1.,0.,0.\n102,-1.,1.,0.\n103,-1.,1.,1.\n104,-1.,0.,1.\n105,-1.,2.,0.\n106,-1.,2.,1.\n" + solids +
         "*ELEMENT_SHELL\n11,2,101,102,103,104\n12,2,102,105,106,103\n"
         "*PART\nrow\n1,1,1\n*PART\nplate\n2,2,1\n*SECTION_SOLID\n1,1\n*SECTION_SHELL\n2,2\n0.1\n*MAT_ELASTIC\n1,1.,1.,"
         "0.\n" +
         contact + more;
}

const std::string eroding = "*CONTACT_ERODING_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n0,1,1\n";

struct Eroded {
  model::Read read;
  ContactSurfaces start, left;
};

Eroded erode(const std::string& deck, const std::vector<bool>& shells, const std::vector<bool>& solids) {
  model::Read read = model::read_text(deck);
  SurfaceStore store(read.model);
  const ContactSurfaces start = store.at(ContactIndex{0});
  const ContactSurfaces left = store.erode(ContactIndex{0}, start, {shells, solids, {}}, read.model.mesh.nodes.x);
  return {std::move(read), start, left};
}

std::size_t segments(const ContactSide& side) { return side.selection.segments.size(); }
bool tracks(const ContactSide& side, std::uint32_t node) {
  const auto& nodes = side.nodes.node;
  return std::find(nodes.begin(), nodes.end(), NodeIndex{node}) != nodes.end();
}

// The first brick of the row fails: its five outer faces go, the one between it and the second comes, turned to where
// it was.
TEST(Erosion, InnerFacesOpen) {
  const Eroded e = erode(row(eroding), {}, {true, false, false});
  EXPECT_EQ(segments(e.start.a), 14u);
  ASSERT_EQ(segments(e.left.a), 10u);
  const Segments& s = e.left.a.selection.segments;
  std::size_t opened = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_NE(s.element[i], 0u);
    const auto& x = e.read.model.mesh.nodes.x;
    const Vector normal =
        (x[s.nodes[i][2].value] - x[s.nodes[i][0].value]).cross(x[s.nodes[i][3].value] - x[s.nodes[i][1].value]);
    if (normal.x() < -0.5) {
      ++opened;
      EXPECT_EQ(x[s.nodes[i][0].value].x(), 1);
    }
    EXPECT_EQ(s.kind[i], SegmentKind::solid);
    EXPECT_EQ(s.half[i], 0);
  }
  EXPECT_EQ(opened, 1u);
  for (const auto* list : {&s.half}) EXPECT_EQ(list->size(), s.size());
  EXPECT_EQ(s.rule.size(), s.size());
  for (std::uint32_t node = 0; node < 16; ++node) EXPECT_EQ(tracks(e.left.a, node), node >= 4) << node;
  EXPECT_EQ(segments(e.left.b), 2u);
}

TEST(Erosion, MiddleBrickOpensBothSides) {
  const Eroded e = erode(row(eroding), {}, {false, true, false});
  EXPECT_EQ(segments(e.left.a), 12u);
  EXPECT_EQ(e.left.a.nodes.size(), 16u);
}

// A shell, then eight bricks around the node in the middle, which no outer face has. Once a corner brick has failed,
// the opened faces bring the middle node, with the thickness of solids, to its place among the shell's and the bricks'
// nodes.
TEST(Erosion, NodesOfOpenedFacesAreTracked) {
  for (const std::int64_t type : {0, 2, 5}) {
    Scene scene;
    scene.plate(scene.part(1, 0.25), {0, 0, 9}, {1, 0, 0}, {0, 1, 0}, 1, 1);
    const PartIndex solid = scene.part(2, 0);
    std::vector<NodeIndex> grid;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) grid.push_back(scene.node(Vector(i, j, k)));
    for (const std::size_t a : {0, 1, 3, 4, 9, 10, 12, 13})
      scene.solid(solid, {grid[a], grid[a + 1], grid[a + 4], grid[a + 3], grid[a + 9], grid[a + 10], grid[a + 13],
                          grid[a + 12]});
    model::Contact& contact = scene.contact("ERODING_SINGLE_SURFACE");
    contact.a = {0, type, 0, true};
    contact.erosop = 1;
    SurfaceStore store(scene.model);
    const auto& x = scene.model.mesh.nodes.x;
    const ContactSurfaces start = store.at(ContactIndex{0});
    const NodeIndex middle = grid[13], corner = grid[0];
    EXPECT_EQ(segments(start.a), 1u + 24);
    EXPECT_FALSE(tracks(start.a, middle.value));
    const std::vector<bool> shells, solids{true};
    const ContactSurfaces left = store.erode(ContactIndex{0}, start, {shells, solids, {}}, x);
    EXPECT_EQ(segments(left.a), 1u + 24 - 3 + 3);
    std::vector<NodeIndex> expected;
    std::vector<double> half;
    std::vector<PartIndex> parts;
    for (const NodeIndex node : positions<NodeIndex>(x.size())) {
      if (node == corner) continue;
      expected.push_back(node);
      half.push_back(node.value < 4 ? 0.125 : 0);
      parts.push_back(node.value < 4 ? PartIndex{0} : solid);
    }
    EXPECT_EQ(left.a.nodes.node, expected) << type;
    EXPECT_EQ(left.a.nodes.half, half) << type;
    EXPECT_EQ(left.a.nodes.part, parts) << type;
    EXPECT_EQ(left.a.nodes.rule.size(), expected.size());
  }
}

// Without EROSOP and IADJ, and in types that do not erode, nothing opens.
TEST(Erosion, OnlyWhereAskedFor) {
  for (const std::string contact : {"*CONTACT_ERODING_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n0,0,0\n",
                                    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n"}) {
    const Eroded e = erode(row(contact), {}, {true, false, false});
    EXPECT_EQ(segments(e.left.a), 9u) << contact;
    EXPECT_EQ(e.left.a.nodes.size(), 12u) << contact;
  }
}

// Nodes of failed elements alone stay where ENMASS says so: 1 of solids, 2 of shells too.
TEST(Erosion, NodesOfFailedElements) {
  for (const int enmass : {0, 1, 2}) {
    const std::string control = fmt::format("*CONTROL_CONTACT\n0.1,0,0,0,0,0,0,{}\n", enmass);
    const Eroded e = erode(row(eroding, control), {true, false}, {true, false, false});
    EXPECT_EQ(tracks(e.left.a, 0), enmass > 0) << enmass;
    EXPECT_EQ(segments(e.left.b), 1u);
    EXPECT_EQ(e.left.b.nodes.size(), enmass == 2 ? 6u : 4u) << enmass;
  }
}

// One element after the other, and all of them at once, leave the same.
TEST(Erosion, StepByStepAsAtOnce) {
  const Eroded once = erode(row(eroding), {false, true}, {true, true, false});
  const model::Read& read = once.read;
  SurfaceStore store(read.model);
  const std::vector<bool> none, shell{false, true}, one{true}, two{true, true, false};
  const auto& x = read.model.mesh.nodes.x;
  const ContactSurfaces first = store.erode(ContactIndex{0}, store.at(ContactIndex{0}), {none, one, {}}, x);
  const ContactSurfaces left = store.erode(ContactIndex{0}, first, {shell, two, {}}, x);
  auto keys = [](const ContactSide& side) {
    std::vector<model::SegmentNodes> sorted;
    for (model::SegmentNodes nodes : side.selection.segments.nodes) {
      std::sort(nodes.begin(), nodes.end(), [](NodeIndex a, NodeIndex b) { return a.value < b.value; });
      sorted.push_back(nodes);
    }
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
      return a[0].value < b[0].value || (a[0] == b[0] && a[1].value < b[1].value);
    });
    return sorted;
  };
  EXPECT_EQ(keys(left.a), keys(once.left.a));
  EXPECT_EQ(left.a.nodes.node, once.left.a.nodes.node);
  EXPECT_EQ(segments(left.b), 1u);
}

// Everything fails: empty sides, no crash; flags beyond the mesh do not count.
TEST(Erosion, Everything) {
  const Eroded e = erode(row(eroding), {true, true, true, true}, {true, true, true, true, true});
  EXPECT_EQ(segments(e.left.a) + segments(e.left.b) + e.left.a.nodes.size() + e.left.b.nodes.size(), 0u);
}

}  // namespace
}  // namespace gapcheck::contact::erosion_test
