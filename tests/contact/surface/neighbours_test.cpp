#include "contact/surface/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "contact/scene.hpp"

namespace gapcheck::contact::neighbours_test {
namespace {

const ContactType single{.code = ContactCode::automatic_single,
                         .treatment = Treatment::single_surface,
                         .family = Family::automatic,
                         .not_checked = {}};

struct Surface {
  Scene scene;
  Segments segments;
  explicit Surface(Scene s) : scene(std::move(s)) {
    MeshIndex index(scene.model);
    segments = select(scene.model, {0, 5, 0, true}, single, scene.model.mesh.nodes.x, index).segments;
  }
};

Scene plate(std::uint32_t n) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, n, n);
  return scene;
}

TEST(Neighbours, ListsTheSegmentsAtANode) {
  const Surface s(plate(2));
  const Neighbours n(s.segments, s.scene.model.mesh);
  EXPECT_EQ(n.at(NodeIndex{4}).size(), 4U);
  EXPECT_EQ(n.at(NodeIndex{0}).size(), 1U);
  EXPECT_EQ(n.at(NodeIndex{1}).size(), 2U);
}

/// An element that a box cuts is still the node's own.
TEST(Neighbours, SegmentsThatABoxCutsAreInTheRing) {
  Surface s(plate(3));
  Segments cut;
  cut.nodes = {s.segments.nodes.back()};
  s.segments.nodes.pop_back();
  const auto last = cut.nodes[0];
  const NodeIndex corner = *std::max_element(last.begin(), last.end());
  const Neighbours without(s.segments, s.scene.model.mesh), with(s.segments, s.scene.model.mesh, false, &cut);
  for (const SegmentIndex i : positions<SegmentIndex>(s.segments.nodes.size())) {
    const auto& nodes = s.segments.nodes[i.value];
    const bool meets = std::any_of(nodes.begin(), nodes.end(),
                                   [&](NodeIndex n) { return std::find(last.begin(), last.end(), n) != last.end(); });
    EXPECT_FALSE(without.in_ring(corner, i));
    EXPECT_EQ(with.in_ring(corner, i), meets) << i.value;
    EXPECT_EQ(with.in_ring(NodeIndex{0}, i), without.in_ring(NodeIndex{0}, i)) << "not of the element that is cut";
  }
}

TEST(Neighbours, RingIsOneElementWide) {
  const Surface s(plate(5));
  const Neighbours n(s.segments, s.scene.model.mesh);
  // The obvious twin: some element has the node and a corner of the segment.
  for (const SegmentIndex segment : positions<SegmentIndex>(s.segments.size()))
    for (std::uint32_t node = 0; node < 36; ++node) {
      bool expected = false;
      const model::SegmentNodes& corners = s.segments.nodes[segment.value];
      for (const auto& own : s.segments.nodes) {
        const auto has = [&](NodeIndex i) { return std::find(own.begin(), own.end(), i) != own.end(); };
        if (has(NodeIndex{node})) expected = expected || std::any_of(corners.begin(), corners.end(), has);
      }
      EXPECT_EQ(n.in_ring(NodeIndex{node}, segment), expected);
    }
}

TEST(Neighbours, SolidsCountWithAllTheirNodes) {
  // A plate one brick thick: top nodes are in the ring of the bottom faces of their own bricks' neighbours.
  Scene scene;
  scene.brick(scene.part(1, 0), {0, 0, 0}, {1, 1, 1});
  const Surface s(std::move(scene));
  const Neighbours n(s.segments, s.scene.model.mesh);
  for (const SegmentIndex segment : positions<SegmentIndex>(6)) EXPECT_TRUE(n.in_ring(NodeIndex{6}, segment));
}

// Of a brick or thick shell whose sides are no segments, the opposite faces are in each other's ring.
TEST(Neighbours, OppositeFacesOfOneElement) {
  using Kind = model::ElementKind;
  for (const auto& [kind, element, expected] :
       {std::tuple{Kind::solid, 0U, true}, std::tuple{Kind::thick_shell, 0U, true}, std::tuple{Kind::shell, 0U, false},
        std::tuple{Kind::solid, no_position, false}}) {
    Scene scene;
    scene.brick(scene.part(1, 0), {0, 0, 0}, {1, 1, 1});
    model::Mesh& mesh = scene.model.mesh;
    const auto n = mesh.solids.nodes[0];
    mesh.thick_shells.nodes = {n};
    Segments s;
    s.nodes = {{n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6], n[7]}};
    s.element = {element, element};
    s.element_kind = {kind, kind};
    s.kind = {SegmentKind::solid, SegmentKind::solid};
    const Neighbours around(s, mesh), whole(s, mesh, true);
    EXPECT_EQ(around.in_ring(n[0], SegmentIndex{1}), expected);
    EXPECT_EQ(around.in_ring(n[6], SegmentIndex{0}), expected);
    EXPECT_TRUE(around.in_ring(n[0], SegmentIndex{0}));
    EXPECT_TRUE(whole.in_ring(n[0], SegmentIndex{1}));
  }
}

TEST(Neighbours, FreeEdges) {
  const Surface s(plate(2));
  const Neighbours n(s.segments, s.scene.model.mesh);
  EXPECT_TRUE(n.free_edge(SegmentIndex{0}, NodeIndex{0}, NodeIndex{1}));
  EXPECT_FALSE(n.free_edge(SegmentIndex{0}, NodeIndex{1}, NodeIndex{4}));
}

}  // namespace
}  // namespace gapcheck::contact::neighbours_test
