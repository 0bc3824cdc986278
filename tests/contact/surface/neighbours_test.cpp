#include "contact/surface/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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
  Surface s(plate(2));
  Segments cut;
  cut.nodes = {s.segments.nodes.back()};
  s.segments.nodes.pop_back();
  const auto last = cut.nodes[0];
  const NodeIndex corner = *std::max_element(last.begin(), last.end());
  const Neighbours without(s.segments, s.scene.model.mesh), with(s.segments, s.scene.model.mesh, false, &cut);
  for (const SegmentIndex i : positions<SegmentIndex>(s.segments.nodes.size())) {
    EXPECT_FALSE(without.in_ring(corner, i));
    EXPECT_TRUE(with.in_ring(corner, i)) << "all of them have the middle node";
  }
  EXPECT_FALSE(with.in_ring(NodeIndex{0}, SegmentIndex{1}) && !without.in_ring(NodeIndex{0}, SegmentIndex{1}));
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

TEST(Neighbours, FreeEdges) {
  const Surface s(plate(2));
  const Neighbours n(s.segments, s.scene.model.mesh);
  EXPECT_TRUE(n.free_edge(SegmentIndex{0}, NodeIndex{0}, NodeIndex{1}));
  EXPECT_FALSE(n.free_edge(SegmentIndex{0}, NodeIndex{1}, NodeIndex{4}));
}

}  // namespace
}  // namespace gapcheck::contact::neighbours_test
