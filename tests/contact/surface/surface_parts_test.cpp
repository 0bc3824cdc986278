#include "contact/surface/surface_parts.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::contact::surface_parts_test {
namespace {

Segments segments_of(const model::Model& model) {
  Segments s;
  for (std::uint32_t i = 0; i < model.mesh.shells.size(); ++i) {
    s.nodes.push_back(model.mesh.shells.nodes[i]);
    s.element.push_back(i);
    s.element_kind.push_back(model::ElementKind::shell);
    s.kind.push_back(SegmentKind::shell);
  }
  return s;
}

void turn(Scene& scene, std::uint32_t shell) {
  auto& n = scene.model.mesh.shells.nodes[shell];
  std::swap(n[1], n[3]);
}

TEST(SurfaceParts, MisorientedAreTheFewer) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  scene.plate(part, Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 3, 3);
  EXPECT_TRUE(misoriented_segments(scene.model.mesh, segments_of(scene.model)).empty());
  turn(scene, 0);
  turn(scene, 4);
  const auto found = misoriented_segments(scene.model.mesh, segments_of(scene.model));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].segment, SegmentIndex{0});
  EXPECT_EQ(found[1].segment, SegmentIndex{4});
  EXPECT_EQ(found[0].part, part);
}

TEST(SurfaceParts, OfTwoEqualLotsTheLater) {
  Scene scene;
  scene.plate(scene.part(1, 1), Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 2, 1);
  turn(scene, 0);
  const auto found = misoriented_segments(scene.model.mesh, segments_of(scene.model));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].segment, SegmentIndex{1});
}

// A strip whose middle shell is the last one: from the first one the way to the second leads back to a lower number.
TEST(SurfaceParts, ConnectedInAnyOrderOfTheShells) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  scene.plate(part, Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 3, 1);
  auto& nodes = scene.model.mesh.shells.nodes;
  std::swap(nodes[1], nodes[2]);
  EXPECT_TRUE(misoriented_segments(scene.model.mesh, segments_of(scene.model)).empty());
  turn(scene, 1);
  const auto found = misoriented_segments(scene.model.mesh, segments_of(scene.model));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].segment, SegmentIndex{1});
  std::size_t surfaces = 0;
  for_each_connected_surface(segments_of(scene.model), [&](const ConnectedSurface& surface) {
    ++surfaces;
    EXPECT_EQ(surface.segments.size(), 3u);
  });
  EXPECT_EQ(surfaces, 1u);
}

// Three shells at one edge: no orientation of a T is consistent, so the edge says nothing.
TEST(SurfaceParts, EdgesOfThreeSegmentsConnectNothing) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  const auto n = scene.plate(part, Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 2, 1);
  const NodeIndex a = scene.node(Vector(1, 0, 1)), b = scene.node(Vector(1, 1, 1));
  scene.shell(part, {n[1], n[4], b, a});
  turn(scene, 0);
  EXPECT_TRUE(misoriented_segments(scene.model.mesh, segments_of(scene.model)).empty());
}

TEST(SurfaceParts, PartsAndMeanEdges) {
  Scene scene;
  const PartIndex one = scene.part(1, 1), two = scene.part(2, 1);
  const auto nodes = scene.plate(two, Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 3, 0), 2, 1);
  scene.plate(one, Vector(0, 0, 9), Vector(1, 0, 0), Vector(0, 3, 0), 1, 1);
  ContactSide side;
  side.selection.segments = segments_of(scene.model);
  EXPECT_EQ(parts_of(scene.model, side), (std::vector<PartIndex>{one, two}));
  EXPECT_DOUBLE_EQ(mean_edge(scene.model, side), 2);  // each quad: 1, 3, 1, 3
  ContactSide bare;
  bare.nodes_only = true;
  bare.selection.nodes = {nodes[0], nodes[1], nodes[3], nodes[4], nodes[5]};
  EXPECT_DOUBLE_EQ(mean_edge(scene.model, bare), 2);
  bare.selection.nodes.resize(3);
  EXPECT_EQ(mean_edge(scene.model, bare), 0);
}

TEST(SurfaceParts, WholePartsHaveNoBox) {
  EXPECT_TRUE(whole_parts({1, 2, 0, true}));
  EXPECT_TRUE(whole_parts({1, 3, 0, true}));
  EXPECT_FALSE(whole_parts({1, 3, 7, true}));
  EXPECT_FALSE(whole_parts({1, 0, 0, true}));
  EXPECT_FALSE(whole_parts({1, 4, 0, true}));
}

}  // namespace
}  // namespace gapcheck::contact::surface_parts_test
